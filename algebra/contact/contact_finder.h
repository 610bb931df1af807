/// @file
/// From two polyhedra in place to their contact relation [thesis, 2.1].
/// Model   The corners of the contact region are the pairs of elements at most `tolerance` apart that no
///         closer pair of lower dimension explains: vertex-vertex, vertex-edge, edge-vertex, vertex-face,
///         face-vertex, edge-edge (crossing). At each, every convex piece of the moving solid against every
///         piece of the fixed one gives a contacting point with its separate planes (separate_planes.h); the
///         motion must respect them all. Line and area contacts are their corners: along them the planes stay
///         the same and velocity is linear. (For a parallel edge-edge contact, whose planes are a union, the
///         corners admit more than the edge between them: see the ledger, thesis.2.1.singular-edges.)
/// Frames  both solids, the points and the normals in one frame, usually the fixed solid's.
/// Exact   every decision; the tolerance is a distance that the caller gives. With zero only contact counts.
/// Cost    O(V (V + E + F) + E^2) box tests, exact arithmetic for the near ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/contact/contact_relation.h"
#include "algebra/contact/local_cone.h"

namespace tact::algebra {

/// One pair of elements in contact, as large as it gets: a face-face contact is listed, the edges and
/// vertices of its rim are not. contacts indexes the relation's contacts that it consists of.
struct ContactPrimitive {
  Element moving, fixed;
  std::vector<size_t> contacts;
};

/// "face-face", "edge-face", "edge-edge", ...; moving element first.
std::string KindOf(const ContactPrimitive& primitive);

/// A point deeper than the tolerance inside both solids.
struct Penetration {
  Vector3 where;
  Rational
      squared_depth;  // to the nearer of the two surfaces; zero if they overlap and no such point was found
};

struct FoundContacts {
  std::optional<Penetration> penetration;
  ContactRelation relation;
  std::vector<ContactPrimitive> primitives;
  /// Per contact, the nearest elements it was found at.
  std::vector<std::pair<Element, Element>> elements;
};

/// If the solids interpenetrate, `penetration` says where and the rest is empty.
/// PreconditionError: a negative tolerance.
FoundContacts FindContacts(const Polyhedron& moving, const Polyhedron& fixed, const Rational& tolerance);

/// The deepest point found of those the solids' vertices and edges have inside the other solid.
std::optional<Penetration> FindPenetration(const Polyhedron& moving, const Polyhedron& fixed,
                                           const Rational& tolerance);

/// Groups a relation's contacts into primitives; `elements` as in FoundContacts.
std::vector<ContactPrimitive> GroupIntoPrimitives(const Polyhedron& moving, const Polyhedron& fixed,
                                                  const ContactRelation& relation,
                                                  const std::vector<std::pair<Element, Element>>& elements,
                                                  const Rational& tolerance);

}  // namespace tact::algebra

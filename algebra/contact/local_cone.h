/// @file
/// What a polyhedron looks like from one of its points: a union of convex cones.
/// Model   The tangent cone of a solid at a point is the union of pieces { d | n . d <= 0 for the outward
///         normals n of the piece }: one half-space at a face, one wedge at a convex edge, two half-spaces at
///         a concave edge, one cone at a convex vertex, and in general the largest intersections of incident
///         faces' half-spaces that fit in (such pieces always cover: every polygon is a monotone formula of
///         its edges' half-planes).
/// Exact   rational; directions carry the length over which the solid really has them.
#pragma once

#include <vector>

#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

enum class ElementKind { kVertex, kEdge, kFace };

/// A vertex, edge or face of a polyhedron, by index.
struct Element {
  ElementKind kind = ElementKind::kVertex;
  size_t index = 0;
  friend auto operator<=>(const Element&, const Element&) = default;
};

/// "vertex 3".
std::string ToString(const Element& element);

/// A convex cone in both forms. Every normal is a facet's; a half-space has one, a wedge two.
struct ConvexPiece {
  std::vector<Vector3> normals;
  /// Generate the cone; both signs of a direction if it holds a line. Lengths are the solid's own.
  std::vector<Vector3> directions;
};

/// The pieces of the solid's own shell at the element (at a point of its relative interior).
/// InvariantError: a vertex so ragged that the pieces do not cover it.
std::vector<ConvexPiece> LocalPieces(const Polyhedron& solid, const Element& element);

}  // namespace tact::algebra

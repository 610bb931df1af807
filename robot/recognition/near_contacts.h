/// @file
/// The point contacts that a pose with errors may have: which elements are near each other and could touch [thesis, 2.7.3].
/// Model   A vertex and a face, or two edges, whose gap and whose distance aside (the foot outside the face, the crossing
///         beyond an edge's end) are both at most `distance`. They must be able to touch when turned by at most
///         `angle`: at the vertex, no edge goes into the other solid; of two edges, both are convex, and the plane between
///         them separates the faces on both sides.
/// Frames  the fixed solid's, F; X_FM is the moving solid's pose in it.
/// Exact   no.
/// Cost    O(vertices faces + edges^2).
#pragma once

#include <optional>
#include <vector>

#include "robot/recognition/point_contact.h"

namespace tact::recognition {

struct NearContacts {
  double distance = 0;  // in the solids' unit
  double angle = 0;     // radian
};

/// Two solids, exact and in doubles.
struct SolidPair {
  SolidPair(const algebra::Polyhedron& moving_solid, const algebra::Polyhedron& fixed_solid)
      : moving(&moving_solid),
        fixed(&fixed_solid),
        moving_f(ToDouble(moving_solid)),
        fixed_f(ToDouble(fixed_solid)) {}
  const algebra::Polyhedron* moving;
  const algebra::Polyhedron* fixed;
  SolidF moving_f, fixed_f;
};

/// How far aside of the elements the contact's point is: of the face's rim, of the edges' ends; zero within.
double AsideOf(const PointContact& contact, const SolidPair& solids, const joint::Transform& X_FM);

/// Sorted. Edges that are parallel to `angle` have none: their ends' vertices have.
std::vector<PointContact> FindNearContacts(const SolidPair& solids, const joint::Transform& X_FM,
                                           const NearContacts& limits);

}  // namespace tact::recognition

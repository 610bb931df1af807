/// @file
/// The point contacts that a pose with errors may have: which elements are near each other and could touch [thesis, 2.7.3].
/// Model   A vertex and a face, or two edges, whose gap and whose distance aside (the foot outside the face, the crossing
///         beyond an edge's end) are both at most `distance`. They must be able to touch when turned by at most
///         `angle`: at the vertex, no edge goes into the other solid; of two edges, both are convex, and the plane between
///         them separates the faces on both sides.
/// Frames  the fixed solid's, F; X_FM is the moving solid's pose in it.
/// Exact   no.
/// Cost    O(vertices faces + edges^2); some ten microseconds for the solids of a peg insertion.
#pragma once

#include <vector>

#include "robot/recognition/proximity_solid.h"

namespace tact::recognition {

struct NearLimits {
  double distance = 0;  // in the solids' unit
  double angle = 0;     // radian
};

struct NearContact {
  PointContact contact;
  double gap = 0;    // as GapOf says it
  double aside = 0;  // not negative
};

/// How far aside of the elements the contact's point is; zero within.
double AsideOf(const PointContact& contact, const ProximitySolid& moving, const ProximitySolid& fixed,
               const joint::Transform& X_FM);

/// Sorted by contact. Edges that are parallel to `angle` have none: their ends' vertices have.
std::vector<NearContact> FindNearContacts(const ProximitySolid& moving, const ProximitySolid& fixed,
                                          const joint::Transform& X_FM, const NearLimits& limits);

}  // namespace tact::recognition

/// @file
/// The location that goes with an orientation while a contact relation is maintained [thesis, A.4.3].
/// Model   With the orientation fixed, every gap is linear in the location, its gradient the unit normal (A.23). Of all
///         locations at which every gap is zero the one nearest to a given location is taken: to the previous one
///         along a turn, so that a redundant location moves no more than it must.
/// Method  The normal farthest from the span of those chosen is chosen next, three at most; the location moves
///         along the orthonormal vectors so made. What is left of the gaps says whether there is a solution.
/// Frames  the fixed solid's.
/// Cost    some 0.3 microseconds for four contacts.
#pragma once

#include "robot/planning/motion_rows.h"

namespace tact::planning {

struct Location {
  Eigen::Vector3d p;
  double violation = 0;  // the largest |gap| there
};

Location NearestLocation(const Relation& relation, const recognition::SolidF& moving,
                         const recognition::SolidF& fixed, const Eigen::Matrix3d& R_FM,
                         const Eigen::Vector3d& from);

/// The largest |gap| of a relation in a pose; 0 for the empty one.
double ViolationOf(const Relation& relation, const recognition::SolidF& moving,
                   const recognition::SolidF& fixed, const joint::Transform& X_FM);

}  // namespace tact::planning

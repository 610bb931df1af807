/// @file
/// What a trajectory meets on its way: overlap of the solids, contacts that leave their elements.
/// Model   At a sample the solids are placed by the rational rotation that is the sample's quaternion, digit by digit, and
///         examined by the exact contact finder. A contact leaves its elements when its point lies outside of the face's
///         polygon or beyond an edge's end.
/// Exact   the overlap, up to the rounding of the sample's pose that kOverlapTolerance covers.
/// Units   the solids' length unit.
/// Cost    milliseconds a sample for solids of ten faces.
#pragma once

#include <string>
#include <vector>

#include "robot/planning/optimal_trajectory.h"

namespace tact::planning {

/// Shares of the moving solid's size: overlap below is contact (poses in doubles err by 1e-15 of it, gaps up to 1e-9 pass).
inline constexpr double kOverlapTolerance = 1e-7;

/// The pose whose quaternion has these doubles.
algebra::Pose ExactPose(const joint::Transform& X);

/// How deep a vertex or a point of an edge lies inside the other solid; 0 if none lies deeper than the tolerance.
double OverlapIn(const SolidPair& solids, const joint::Transform& X_FM);

/// How far a contact's point is off its elements; 0 inside.
double OffElements(const recognition::PointContact& contact, const SolidPair& solids,
                   const joint::Transform& X_FM);

struct TrajectoryCheck {
  std::vector<double> overlaps;  // of each sample
  double overlap = 0;            // the largest
  std::string failure;           // the first thing wrong, with its sample counted from 1; "" if nothing is
};

TrajectoryCheck CheckTrajectory(const SolidPair& solids, const ContactState& start, const ContactState& end,
                                const Trajectory& trajectory);

}  // namespace tact::planning

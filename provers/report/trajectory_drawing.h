/// @file
/// A trajectory drawn: the fixed solid, the moving one solid at its end, dotted on the way.
/// Frames  the fixed solid's; seen from where the motion shows most.
/// Exact   no.
#pragma once

#include <string>

#include "provers/report/projection.h"
#include "robot/planning/optimal_trajectory.h"

namespace tact::provers {

/// From the front, above, round the vertical: the view in which the moving solid's vertices go farthest.
View ViewOfMotion(const planning::SolidPair& solids, const std::vector<planning::Sample>& samples);

/// One <svg> element. The contacts at the end are marked. PreconditionError: no samples.
std::string DrawTrajectory(const planning::SolidPair& solids, const std::vector<planning::Sample>& samples);

}  // namespace tact::provers

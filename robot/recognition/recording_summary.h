/// @file
/// What a recording shows at a glance, and what looks wrong with it; nothing is changed.
/// Frames  F; locations are those of the moving model's origin.
/// Units   the models'; radian.
#pragma once

#include <string>
#include <vector>

#include "robot/input/recorded_demonstration.h"
#include "robot/recognition/proximity_solid.h"

namespace tact::recognition {

/// Times the usual step: a pause, or scenes lost; and a pose that is away from both neighbours by as much is an outlier.
inline constexpr double kWideGap = 8;
/// Deviations of the fixed object's scatter: who moves by more was moved, or lost.
inline constexpr double kFixedMoves = 20;
/// Times both solids' radii between their centroids: nearer than this in no scene, and unit or frame are in doubt.
inline constexpr double kNeverNear = 3;

struct RecordingSummary {
  Eigen::Vector3d low, high;        // box of locations
  double path = 0;                  // length of the way from scene to scene
  double turn = 0;                  // largest angle to the first scene
  std::vector<std::string> doubts;  // a sentence each
};

/// PreconditionError: a recording without scenes.
RecordingSummary Summarise(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                           const ProximitySolid& fixed);

}  // namespace tact::recognition

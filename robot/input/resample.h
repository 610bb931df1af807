/// @file
/// Recordings with fewer scenes, or with scenes at even times.
/// Model   Between two scenes the location moves on a straight line and the orientation turns about one axis, both evenly
///         (slerp); without times the scenes are taken as one unit of time apart.
#pragma once

#include "robot/input/recorded_demonstration.h"

namespace tact::input {

/// A share of the way from a to b: 0 is a, 1 is b. The turn is the shorter one.
joint::Transform Interpolate(const joint::Transform& a, const joint::Transform& b, double share);

/// The first scene and every k-th after it, as they are. PreconditionError: k < 1.
RecordedDemonstration EveryKth(const RecordedDemonstration& recording, size_t k);

/// count scenes from the first to the last time, evenly; a scene that has just such a time stays as it is, others are
/// interpolated and named by their number. PreconditionError: count < 2, unless the recording has one scene only.
RecordedDemonstration AtEvenTimes(const RecordedDemonstration& recording, size_t count);

}  // namespace tact::input

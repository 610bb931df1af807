/// @file
/// How far poses of a recording are wrong, told by the recording itself.
/// Model   Two measures, and the larger counts:
///         - repeatability: the fixed object does not move, so the scatter of its observed poses is the tracker's; a median over
///           the scenes, at its vertices, times sqrt(2) for the moving object errs as well;
///         - overlap: solids do not interpenetrate, so vertices of one inside the other are errors, with what the tracker always
///           does wrong in them, which does not scatter; the median depth of Gaussian errors is 0.6745 deviations.
/// Units   the models'.
/// Cost    O(scenes (V F)).
#pragma once

#include <optional>
#include <string>

#include "robot/input/recorded_demonstration.h"
#include "robot/recognition/proximity_solid.h"

namespace tact::recognition {

/// With fewer vertices inside the other solid their median says little.
inline constexpr size_t kLeastOverlaps = 6;

struct NoiseLevel {
  std::optional<double> repeatability, overlap;  // deviations of a contact's gap
  size_t overlaps = 0;                           // vertices the latter comes from
  /// The larger; nullopt if the recording tells neither.
  std::optional<double> deviation() const;
};

NoiseLevel MeasureNoise(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                        const ProximitySolid& fixed);

}  // namespace tact::recognition

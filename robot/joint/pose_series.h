/// @file
/// Poses of a link A in a link B, in the order of time, from logs: one of A in B, or one of each in a common frame W (two tracked
/// markers, say), X_BA = X_WB^-1 X_WA.
/// Model   Two logs with times are matched: to each pose of A the nearest of B in time, no farther than a limit. Without times both
///         must be equally long.
/// Errors  InputError: logs that cannot be matched.
/// Cost    O(N).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/input/pose_log.h"
#include "robot/joint/transform.h"

namespace tact::joint {

/// Between two poses a turn of more than 180 degrees looks like one the other way; from this on it is worth a word.
inline constexpr double kWideStep = 2.0944;  // radian: 120 degrees
/// Millimetres among metres: distances from the origin fall into two groups, a factor in this range apart.
inline constexpr double kUnitFactorLeast = 300, kUnitFactorMost = 3000;
/// Metre: doors and drawers are nearer.
inline constexpr double kFarAway = 50;

struct PoseSeries {
  std::vector<Transform> poses;    // X_BA
  std::vector<Transform> X_WB;     // of two logs, B's pose for each; empty for one log
  std::vector<double> times;       // second; empty: the log has none
  std::vector<std::size_t> lines;  // of the (first) log
  std::vector<std::string> notes;  // what was matched and left out
};

/// inverse: the log is of B in A.
PoseSeries SeriesOf(const input::PoseLog& log, bool inverse = false);

/// limit: second; none: half the usual step between times of B.
PoseSeries SeriesOf(const input::PoseLog& A_in_W, const input::PoseLog& B_in_W,
                    std::optional<double> limit = std::nullopt);

/// What looks wrong, a sentence each; nothing is changed: wide turns between poses, repeated poses, mixed units, a unit
/// that makes everything far away.
std::vector<std::string> Suspicions(const PoseSeries& series);

}  // namespace tact::joint

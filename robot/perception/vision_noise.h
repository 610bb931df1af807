/// @file
/// The noise of the thesis' vision system [thesis, 4.5.2, eq. (4.28), (4.29)], as a generator.
/// Model   R <- exp(w) R and p <- p + d, in the frame that the pose is in: |w| uniform in [0, turn], |d| uniform in [0, shift],
///         both in uniform directions. (So small errors are more frequent than in a ball: their density has a pole.)
/// Units   radian; shift has the unit of the poses.
/// Exact   the same on every machine for the same stream of uniform numbers.
#pragma once

#include <cstdint>
#include <numbers>

#include "robot/input/recorded_demonstration.h"
#include "robot/joint/transform.h"

namespace tact::perception {

/// Largest errors; these are the thesis'.
struct VisionNoise {
  double turn = 5 * std::numbers::pi / 180;  // radian
  double shift = 0.01;                       // the thesis' 10 mm, in metre
};

/// Random has Uniform(), in [0, 1), and Direction(), of length one; each is drawn twice, the turn's direction first.
template <typename Random>
joint::Transform AddVisionNoise(const joint::Transform& X, const VisionNoise& most, Random& random) {
  const Eigen::Vector3d axis = random.Direction();
  const double turn = most.turn * random.Uniform();
  const Eigen::Vector3d way = random.Direction();
  const double shift = most.shift * random.Uniform();
  return {joint::RotationExp(turn * axis) * X.R, X.p + shift * way};
}

/// Noise on X_FM of every scene; shift in the recording's unit. What was seen of the fixed object, and exact poses, go.
input::RecordedDemonstration MakeNoisy(input::RecordedDemonstration recording, const VisionNoise& most,
                                       std::uint64_t seed);

}  // namespace tact::perception

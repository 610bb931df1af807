/// @file
/// How well a joint predicts poses that it was not estimated from.
/// Model   The poses are dealt out to kFolds groups in turn. Each group is held back once: the joint is estimated from the others,
///         and each pose held back is compared with the pose nearest to it, in units of the noise, that this joint allows.
/// Units   radian, metre: lengths of the error's rotation vector and translation.
/// Cost    kFolds estimates.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

inline constexpr int kFolds = 5;

/// Errors of poses, in their order.
struct PoseErrors {
  std::vector<double> rotation, translation;
};

/// Of poses, in the order of time, against the nearest ones that the joint allows.
PoseErrors ErrorsOf(const Joint& joint, const NoiseScale& noise, std::span<const Transform> poses);

using Estimator = std::function<JointFit(std::span<const Transform>)>;

/// Of each pose when it is held back. Pre: more than kFolds poses.
PoseErrors PredictHeldBack(std::span<const Transform> poses, const Estimator& estimate);

}  // namespace tact::joint

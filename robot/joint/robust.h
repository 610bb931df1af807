/// @file
/// Joints from poses of which many may be wrong.
/// Model   Each pose is right with probability 1 - e, then Gaussian about the joint (maximum_likelihood.h) with its
///         coordinates normal too (coordinate_spread.h); else it lies anywhere: any orientation alike, A's origin
///         anywhere in the box of all poses. A start by consensus (consensus.h), then expectation and maximization: the
///         weight of a pose is the probability that it is right.
/// Exact   no; the same seed gives the same answer.
/// Cost    O(N) an iteration.
#pragma once

#include <cstdint>

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

struct RobustOptions {
  std::uint64_t seed = 1;
  int samples = 50;        // of the consensus
  NoiseScale least_noise;  // the scales are estimated as at least these
};

struct RobustFit {
  JointFit fit;                       // covariance: sandwich of the weighted equations
  std::vector<double> weights;        // of each pose, the probability that it is right
  std::vector<std::size_t> outliers;  // poses more probably wrong than right, ascending
  double share_wrong = 0;             // e
  double log_likelihood = 0;          // of all poses, nat; marginal over coordinates and over right or wrong
};

/// Pre: poses not empty.
RobustFit FitRobustly(JointType type, std::span<const Transform> poses, const RobustOptions& options = {});

}  // namespace tact::joint

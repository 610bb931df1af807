/// @file
/// The best estimate under the thesis' noise law: the posterior mean.
/// Model   rectangular_likelihood.h; prior flat in the parameters near the maximum likelihood fit and, if the bounds
///         are not known, in their logarithms. Metropolis' sampler, its proposal adapted in the first half and then
///         kept. The mean of a posterior has the least mean squared error that any estimate can have under that prior.
/// Exact   no; the same seed gives the same answer.
/// Errors  PreconditionError: a type of more than one DOF. Of a pose's two errors its coordinates then move so much
///         that the integral over them has no closed form.
/// Cost    O(N) a sample, some 0.1 s for 100 poses.
#pragma once

#include <cstdint>
#include <optional>

#include "robot/joint/rectangular_likelihood.h"

namespace tact::joint {

struct PosteriorOptions {
  std::optional<NoiseBounds> bounds;  // none: estimated
  std::uint64_t seed = 1;
  int samples = 16000;  // the first half adapts, the second counts
};

struct PosteriorMean {
  JointFit
      fit;  // joint, coordinates and covariance of the posterior; noise: the law's root mean square a component
  NoiseBounds bounds;
  double acceptance = 0;    // of the proposals that count
  std::size_t outside = 0;  // poses that no joint found keeps within the bounds given
};

/// Pre: poses not empty.
PosteriorMean FitPosteriorMean(JointType type, std::span<const Transform> poses,
                               const PosteriorOptions& options = {});

}  // namespace tact::joint

/// @file
/// How much one pose's residual tells of the next ones'.
/// Model   1 + 2 (sum of autocorrelations), up to the first lag at which two of them together are no longer positive
///         (Geyer's initial positive sequence); of orientations and of locations, the larger. White noise gives about
///         1: the mean of N correlated residuals is as uncertain as that of N over this of independent ones.
#pragma once

#include <span>

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

/// At least 1, at most a fifth of the poses. weights: poses below one half are left out.
double ResidualCorrelation(const JointFit& fit, std::span<const Transform> poses,
                           std::span<const double> weights);

}  // namespace tact::joint

/// @file
/// How probable a pose is under a joint when its coordinates are not chosen but drawn: normal random effects.
/// Model   The coordinates of all poses have a mean and a covariance C; the density of a pose is the integral over its
///         coordinates, by Laplace's method: -r^2/2 - log|2 pi Sigma|/2 + k/2 log 2 pi - log|J_q^T Sigma^-1 J_q|/2 +
///         log N(q; mean, C), with r^2 the least squared error. Coordinates that spread like the noise gain nothing
///         over a joint without them.
/// Units   densities a radian^3 metre^3, log in nat.
#pragma once

#include <span>

#include "robot/joint/pose_equations.h"

namespace tact::joint {

struct CoordinateSpread {
  int dof = 0;
  Eigen::Vector3d mean;
  Eigen::Matrix3d precision;  // of C
  double log_normalizer = 0;  // -log|2 pi C|/2
};

/// Of coordinates that count as often as the weights say; none: once. equations: at the coordinates; C gets nowhere
/// smaller than the uncertainty of the coordinates themselves.
CoordinateSpread SpreadOf(int dof, std::span<const Coordinates> coordinates,
                          std::span<const PoseEquations> equations, std::span<const double> weights);

/// The log density of a pose, with its equations at the coordinates.
double LogDensity(const CoordinateSpread& spread, JointType type, const Coordinates& q,
                  const PoseEquations& equations, const NoiseScale& noise);

/// The log density of a pose that may lie anywhere: any orientation alike, the origin in the box of all poses and a
/// margin about it.
double LogAnywhere(std::span<const Transform> poses);

/// log((1 - share) exp(density) + share exp(anywhere)).
double LogMixture(double density, double anywhere, double share);

}  // namespace tact::joint

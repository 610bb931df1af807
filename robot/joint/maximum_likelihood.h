/// @file
/// Joints by maximum likelihood under Gaussian noise whose scales are estimated too: orientation and location weigh in
/// together, coupled through the joint.
/// Model   R_BA = exp(w) R_model, p_BA = p_model + d; w ~ N(0, s_R^2 I), d ~ N(0, s_p^2 I), independent, in B [thesis,
///         eq. (4.28)]. Unknown: the joint's parameters, each pose's coordinates, s_R, s_p. Gauss-Newton on parameters
///         and coordinates, the coordinates eliminated pose by pose (pose_equations.h); the scales by variance
///         components, for the likelihood itself would call them too small when each pose brings coordinates of its own
///         (Neyman and Scott).
/// Units   radian, metre, a component.
/// Cost    O(N) an iteration, five to ten of them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robot/joint/pose_equations.h"

namespace tact::joint {

struct JointFit {
  Joint joint;
  std::vector<Coordinates> coordinates;  // of each pose; angles continuous along their order
  NoiseScale noise;
  ParameterMatrix
      information;  // about the change of parameters that Changed takes, from the joint to the truth
  ParameterMatrix covariance;  // of that change
  int rank = 0;        // of the information: smaller than its size, the poses leave some parameters open
  double squares = 0;  // weighted sum of squared errors
  int iterations = 0;
  bool converged = false;
};

struct FitOptions {
  std::optional<NoiseScale> noise;  // known scales; none: estimated
  std::span<const double> weights;  // how often each pose counts; none: once
  int most_iterations = 100;
};

/// Climbs from one joint. Pre: poses not empty.
JointFit ClimbLikelihood(const Joint& start, std::span<const Transform> poses,
                         const FitOptions& options = {});

/// The best of the climbs from StartsOf (least_squares.h), in the normal form of joint_gauge.h.
JointFit FitMaximumLikelihood(JointType type, std::span<const Transform> poses,
                              const FitOptions& options = {});

}  // namespace tact::joint

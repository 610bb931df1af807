/// @file
/// One pose's linear equations for a joint's parameters, its own coordinates eliminated, and their sums over poses.
/// Model   error = J_p dp + J_q dq + noise, rows in units of the noise. J_q = Q T with orthonormal Q; what is left
///         after the best dq is P error = P J_p dp + P noise with P = I - Q Q^T.
#pragma once

#include "robot/joint/joint_jacobian.h"

namespace tact::joint {

/// Standard deviations of a component: radian, metre.
struct NoiseScale {
  double rotation = 0;
  double translation = 0;
};

struct PoseEquations {
  ParameterJacobian parameters;  // P J_p
  Vector6 error;                 // P error
  Eigen::Vector3d step;          // the best dq at dp = 0
  Eigen::Matrix3d T;             // upper triangle; a coordinate that moves nothing has a zero on the diagonal
  double turning = 0;  // redundancy of orientations that the coordinates take: squared norm of Q's upper half
  double coupling = 0;  // squared norm of P's upper right quarter

  double Squares() const { return error.squaredNorm(); }
};
PoseEquations EquationsAt(const Joint& joint, const Coordinates& q, const Transform& X_BA,
                          const NoiseScale& noise);

/// Sums of equations, each pose counted as often as its weight says; index 0 orientation, 1 location.
struct NormalEquations {
  std::array<ParameterMatrix, 2> information;
  ParameterVector gradient;
  std::array<double, 2> squares{}, redundancy{};
  double coupling = 0;

  explicit NormalEquations(int parameters);
  void Add(const PoseEquations& pose, int dof, double weight);
  ParameterMatrix Information() const { return information[0] + information[1]; }
};

/// The factors by which the scales grow, so that each group's sum of squares is what it is expected to be (Helmert's
/// variance components, which converge fast although the groups share each pose's coordinates). covariance: of the
/// parameters.
std::array<double, 2> ScaleFactors(const NormalEquations& normal, const ParameterMatrix& covariance);

}  // namespace tact::joint

/// @file
/// First derivatives of a joint's poses: what a small change of the joint's parameters and coordinates does to X_BA.
/// Model   Parameters change by X_BJ <- X_BJ exp(xi_B), X_AJ <- X_AJ exp(xi_A), pitch and offset by addition, each type
///         along the free columns that change the set of poses and only those (JointParameters(type) of them): a change
///         of the others is the same as one of the coordinates. A spherical joint's coordinates change by R <- exp(dq)
///         R.
/// Shapes  rows: rotation vector (3), translation of A's origin (3), both in the joint's frame J as fixed in B.
#pragma once

#include "robot/joint/joint.h"

namespace tact::joint {

inline constexpr int kMostParameters = 11;
inline constexpr int kMostDof = 3;

using Vector6 = Eigen::Matrix<double, 6, 1>;
using ParameterVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostParameters, 1>;
using ParameterMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostParameters, kMostParameters>;
using ParameterJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMostParameters>;
using CoordinateJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMostDof>;

/// How many parameters a joint of the type has.
int JointParameters(JointType type);

/// obs - model in J: the rotation vector from the model's orientation to X_BA's, and the translation.
Vector6 PoseError(const Joint& joint, const Coordinates& q, const Transform& X_BA);

struct JointJacobian {
  ParameterJacobian parameters;
  CoordinateJacobian coordinates;
};
JointJacobian JacobianAt(const Joint& joint, const Coordinates& q);

/// The joint after a change of its parameters.
Joint Changed(const Joint& joint, const ParameterVector& change);

/// Coordinates after a change.
Coordinates Changed(const Joint& joint, const Coordinates& q, const Eigen::Vector3d& change);

}  // namespace tact::joint

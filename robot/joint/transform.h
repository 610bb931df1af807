/// @file
/// Rigid transformations in doubles.
/// Model   X_AB = (R_AB, p_AB): the pose of B in A; products cancel by eye, X_AC = X_AB * X_BC.
/// Units   metre, radian.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "algebra/screw/pose.h"

namespace tact::joint {

struct Transform {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();

  Transform Inverse() const { return {R.transpose(), -(R.transpose() * p)}; }
};

inline Transform operator*(const Transform& a, const Transform& b) { return {a.R * b.R, a.p + a.R * b.p}; }
inline Eigen::Vector3d operator*(const Transform& a, const Eigen::Vector3d& point) {
  return a.p + a.R * point;
}

/// An exact pose in doubles.
inline Transform ToTransform(const algebra::Pose& X) {
  Transform answer;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) answer.R(i, j) = ToDouble(X.rotation.rows[static_cast<std::size_t>(i)][j]);
    answer.p[i] = ToDouble(X.translation[i]);
  }
  return answer;
}

/// The rotation about w by |w| radian.
inline Eigen::Matrix3d RotationExp(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Quaterniond q = angle < 1e-9
                                   ? Eigen::Quaterniond(1, w.x() / 2, w.y() / 2, w.z() / 2).normalized()
                                   : Eigen::Quaterniond(Eigen::AngleAxisd(angle, w / angle));
  return q.toRotationMatrix();
}

/// The rotation vector of R, of length at most pi.
inline Eigen::Vector3d RotationLog(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d twice_sine(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double sine = twice_sine.norm() / 2, cosine = (R.trace() - 1) / 2;
  if (cosine > 0)
    return sine < 1e-9 ? Eigen::Vector3d(twice_sine / 2)
                       : Eigen::Vector3d(twice_sine * (std::asin(std::min(1.0, sine)) / (2 * sine)));
  Eigen::Quaterniond q(R);
  if (q.w() < 0) q.coeffs() *= -1;
  const double norm = q.vec().norm();
  return q.vec() * (2 * std::atan2(norm, q.w()) / norm);
}

}  // namespace tact::joint

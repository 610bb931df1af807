#include "robot/joint/pose_equations.h"

#include <cmath>

namespace tact::joint {

PoseEquations EquationsAt(const Joint& joint, const Coordinates& q, const Transform& X_BA,
                          const NoiseScale& noise) {
  JointJacobian jacobian = JacobianAt(joint, q);
  PoseEquations pose{
      jacobian.parameters, PoseError(joint, q, X_BA), Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0, 0};
  const auto weigh = [&noise](auto& rows) {
    rows.template topRows<3>() /= noise.rotation;
    rows.template bottomRows<3>() /= noise.translation;
  };
  weigh(pose.parameters);
  weigh(pose.error);
  weigh(jacobian.coordinates);

  // Gram and Schmidt; a column that adds nothing moves no coordinate.
  const Eigen::Index dof = jacobian.coordinates.cols();
  CoordinateJacobian& Q = jacobian.coordinates;
  Eigen::Matrix3d& T = pose.T;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < dof; ++i) {
    const double length = Q.col(i).norm();
    for (Eigen::Index j = 0; j < i; ++j) {
      T(j, i) = Q.col(j).dot(Q.col(i));
      Q.col(i) -= T(j, i) * Q.col(j);
    }
    T(i, i) = Q.col(i).norm();
    if (T(i, i) <= 1e-12 * length) {
      T(i, i) = 0;
      Q.col(i).setZero();
      continue;
    }
    Q.col(i) /= T(i, i);
    right[i] = Q.col(i).dot(pose.error);
    pose.error -= right[i] * Q.col(i);
    pose.parameters.noalias() -= Q.col(i) * (Q.col(i).transpose() * pose.parameters).eval();
  }
  for (Eigen::Index i = dof - 1; i >= 0; --i) {
    if (T(i, i) == 0) continue;
    double rest = right[i];
    for (Eigen::Index j = i + 1; j < dof; ++j) rest -= T(i, j) * pose.step[j];
    pose.step[i] = rest / T(i, i);
  }
  Eigen::Matrix3d upper = Eigen::Matrix3d::Zero();
  upper.topLeftCorner(dof, dof).noalias() = Q.topRows<3>().transpose() * Q.topRows<3>();
  pose.turning = upper.trace();
  pose.coupling = pose.turning - upper.squaredNorm();
  return pose;
}

NormalEquations::NormalEquations(int parameters) : gradient(ParameterVector::Zero(parameters)) {
  information.fill(ParameterMatrix::Zero(parameters, parameters));
}

void NormalEquations::Add(const PoseEquations& pose, int dof, double weight) {
  for (std::size_t group = 0; group < 2; ++group) {
    const auto at = static_cast<Eigen::Index>(3 * group);
    information[group].noalias() +=
        (weight * pose.parameters.middleRows<3>(at)).transpose() * pose.parameters.middleRows<3>(at);
    squares[group] += weight * pose.error.segment<3>(at).squaredNorm();
  }
  gradient.noalias() += weight * (pose.parameters.transpose() * pose.error);
  redundancy[0] += weight * (3 - pose.turning);
  redundancy[1] += weight * (3 - dof + pose.turning);
  coupling += weight * pose.coupling;
}

std::array<double, 2> ScaleFactors(const NormalEquations& normal, const ParameterMatrix& covariance) {
  // Expected squares of group g: sum over h of shares(g, h) factor_h^2.
  Eigen::Matrix2d shares;
  for (int group = 0; group < 2; ++group) {
    const auto at = static_cast<std::size_t>(group);
    const double redundancy = normal.redundancy[at] - covariance.cwiseProduct(normal.information[at]).sum();
    const double shared = std::min(normal.coupling, std::max(0.0, 0.999 * redundancy));
    shares(group, group) = redundancy - shared;
    shares(group, 1 - group) = shared;
  }
  const double determinant = shares.determinant();
  std::array<double, 2> factors{};
  for (int group = 0; group < 2; ++group) {
    const auto at = static_cast<std::size_t>(group), other = 1 - at;
    const double redundancy = shares.row(group).sum();
    if (redundancy < 1e-6) {
      factors[at] = 1;
      continue;
    }
    const double alone = normal.squares[at] / redundancy;  // Foerstner's, never negative
    const double both = (shares(1 - group, 1 - group) * normal.squares[at] -
                         shares(group, 1 - group) * normal.squares[other]) /
                        determinant;
    factors[at] = std::sqrt(determinant > 0 && both > alone / 4 && both < alone * 4 ? both : alone);
  }
  return factors;
}

}  // namespace tact::joint

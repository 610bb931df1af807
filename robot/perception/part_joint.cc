#include "robot/perception/part_joint.h"

#include <cmath>
#include <numeric>

#include "robot/joint/small_matrix.h"

namespace tact::perception {
namespace {

using Eigen::Matrix3d;
using joint::Transform;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Gain = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, joint::kMostParameters, 6>;

Matrix3d CrossMatrix(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

// What a small change of an observed pose (rotation vector, translation; in J) makes of the fitted parameters.
Gain GainOf(const joint::JointFit& fit, std::size_t pose) {
  Eigen::Matrix<double, 6, 1> weight;
  weight << Vector3d::Constant(1 / fit.noise.rotation), Vector3d::Constant(1 / fit.noise.translation);
  const joint::JointJacobian jacobian = JacobianAt(fit.joint, fit.coordinates[pose]);
  joint::ParameterJacobian J = weight.asDiagonal() * jacobian.parameters;
  const Eigen::Matrix<double, 6, 1> along = (weight.asDiagonal() * jacobian.coordinates.col(0)).normalized();
  J -= along * (along.transpose() * J).eval();
  return fit.covariance * J.transpose() * weight.asDiagonal();
}

// What errors of the two parts' motions, as twists about the first scan's origin in its frame, make of the pose X_BA in B.
Matrix6 PoseChange(const Transform& motion, const Vector3d& centroid, std::size_t part) {
  const Vector3d at = part == 0 ? Vector3d(motion * centroid) : centroid;
  Matrix6 change = Matrix6::Identity();
  change.bottomLeftCorner<3, 3>() = -CrossMatrix(at);
  if (part == 0) return -change;
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = motion.R;
  return turned * change;
}

joint::ParameterMatrix CovarianceOf(const Division& division, const PartAxis& axis) {
  const Eigen::Index parameters = axis.fit.covariance.rows();
  joint::ParameterMatrix covariance = joint::ParameterMatrix::Zero(parameters, parameters);
  Matrix6 to_J = Matrix6::Zero();
  to_J.topLeftCorner<3, 3>() = to_J.bottomRightCorner<3, 3>() = axis.fit.joint.X_BJ.R.transpose();
  for (std::size_t part = 0; part < 2; ++part) {
    Gain shared = Gain::Zero(parameters, 6);
    Matrix6 shared_unit = Matrix6::Zero();
    for (std::size_t i = 1; i < division.scans.size(); ++i) {
      const DividedScan& scan = division.scans[i];
      const Transform motion = scan.X_S0[0].Inverse() * scan.X_S0[1];
      const Gain gain = GainOf(axis.fit, i) * to_J * PoseChange(motion, axis.X_0B.p, part);
      covariance += scan.noise * scan.noise * (gain * scan.unit_covariances[part] * gain.transpose());
      shared += gain;
      shared_unit += scan.unit_covariances[part] / static_cast<double>(division.scans.size() - 1);
    }
    const double noise = division.scans[0].noise;
    covariance += noise * noise * (shared * shared_unit * shared.transpose());
  }
  return covariance;
}

// The same axis the other way round.
void Reverse(PartAxis* axis) {
  const Vector3d half_turn_about_x(1, -1, -1);
  axis->frame *= half_turn_about_x.asDiagonal();
  axis->direction = -axis->direction;
  for (double& angle : axis->angles) angle = 0 - angle;  // no -0
  const Eigen::Vector4d signs(1, -1, 1, -1);
  axis->covariance = signs.asDiagonal() * axis->covariance * signs.asDiagonal();
}

}  // namespace

PartAxis AxisOf(const Division& division, std::span<const Vector3d> first_scan) {
  Vector3d centroid = Vector3d::Zero();
  for (const Vector3d& p : first_scan) centroid += p;
  centroid /= static_cast<double>(first_scan.size());

  PartAxis axis;
  axis.X_0B.p = centroid;
  std::vector<Transform> poses;
  for (const DividedScan& scan : division.scans)
    poses.push_back((scan.X_S0[0] * axis.X_0B).Inverse() * (scan.X_S0[1] * axis.X_0B));
  axis.fit = FitMaximumLikelihood(joint::JointType::kRevolute, poses);

  const Transform X_0J = axis.X_0B * axis.fit.joint.X_BJ;
  axis.frame = X_0J.R;
  axis.direction = X_0J.R.col(2);
  const double along = axis.direction.dot(centroid - X_0J.p);
  axis.point = X_0J.p + along * axis.direction;
  for (const joint::Coordinates& q : axis.fit.coordinates)
    axis.angles.push_back(q[0] - axis.fit.coordinates.front()[0]);
  // The fit's first four parameters are these with J where the fit has put it: `along` away.
  Eigen::Matrix4d to_point = Eigen::Matrix4d::Identity();
  to_point(2, 1) = along;
  to_point(3, 0) = -along;
  axis.covariance = to_point * CovarianceOf(division, axis).topLeftCorner<4, 4>() * to_point.transpose();
  if (std::accumulate(axis.angles.begin(), axis.angles.end(), 0.0) < 0) Reverse(&axis);
  axis.direction_error = std::sqrt(axis.covariance.topLeftCorner<2, 2>().trace());
  axis.point_error = std::sqrt(axis.covariance.bottomRightCorner<2, 2>().trace());
  return axis;
}

AxisError ErrorOf(const PartAxis& axis, const Vector3d& true_point, const Vector3d& true_direction) {
  const double sign = true_direction.dot(axis.direction) < 0 ? -1 : 1;
  const Vector3d z = sign * (axis.frame.transpose() * true_direction.normalized());
  const Vector3d p = axis.frame.transpose() * (true_point - axis.point);
  // J turned by w has the z axis (w_y, -w_x, 1); the true axis passes J's plane z = 0 there.
  const Eigen::Vector2d slope = z.head<2>() / z.z(), shift = p.head<2>() - p.z() * slope;
  const Eigen::Vector4d e(-slope.y(), slope.x(), shift.x(), shift.y());
  return {std::atan(slope.norm()), shift.norm(),
          e.dot(Eigen::Vector4d(joint::PseudoInverse(axis.covariance) * e))};
}

}  // namespace tact::perception

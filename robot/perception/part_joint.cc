#include "robot/perception/part_joint.h"

#include <cmath>

namespace tact::perception {

using joint::Transform;

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
  axis.direction = X_0J.R.col(2);
  const double along = axis.direction.dot(centroid - X_0J.p);
  axis.point = X_0J.p + along * axis.direction;
  for (const joint::Coordinates& q : axis.fit.coordinates)
    axis.angles.push_back(q[0] - axis.fit.coordinates.front()[0]);
  // The changes of the fit's first four parameters: J turned about x and y, moved along x and y.
  const Eigen::Matrix4d covariance = axis.fit.covariance.topLeftCorner<4, 4>();
  Eigen::Matrix<double, 2, 4> move_of_point;
  move_of_point << 0, along, 1, 0, -along, 0, 0, 1;
  axis.direction_error = std::sqrt(covariance.topLeftCorner<2, 2>().trace());
  axis.point_error = std::sqrt((move_of_point * covariance * move_of_point.transpose()).trace());
  return axis;
}

}  // namespace tact::perception

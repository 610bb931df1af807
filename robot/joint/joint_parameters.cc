#include "robot/joint/joint_parameters.h"

#include <cmath>

#include "robot/joint/joint_gauge.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Eigen::Vector3d;
using Kind = ParameterKind;
using Row = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostParameters>;

constexpr double kStep = 1e-5;  // of central differences, radian or metre: their error is its square
// A change of a parameter along columns that the poses leave open, compared with all of its change.
constexpr double kOpenShare = 1e-4;

NamedParameter Named(std::string_view name, Kind kind, Link frame, const Vector3d& value) {
  NamedParameter parameter{name, kind, frame, Eigen::Vector4d::Zero(), Eigen::Matrix3d::Zero(), false, 0};
  parameter.value.head<3>() = value;
  return parameter;
}

NamedParameter OrientationOf(const Eigen::Matrix3d& R_BA) {
  Eigen::Quaterniond q(R_BA);
  if (q.w() < 0) q.coeffs() *= -1;
  NamedParameter parameter = Named("orientation", Kind::kOrientation, Link::kB, Vector3d::Zero());
  parameter.value << q.w(), q.x(), q.y(), q.z();
  return parameter;
}

// The parameters' values alone.
std::vector<NamedParameter> ValuesOf(const Joint& joint, const Transform& reference) {
  const Transform X_BA = PoseAt(joint, CoordinatesNear(joint, reference));
  const Vector3d l_A = joint.X_AJ.R.col(2), l_B = joint.X_BJ.R.col(2);
  const auto direction = [](Link link, const Vector3d& value) {
    return Named("direction", Kind::kDirection, link, value);
  };
  const auto point = [](Link link, const Vector3d& value) {
    return Named("point", Kind::kPoint, link, value);
  };
  const Vector3d foot_A = joint.X_AJ.p - l_A * l_A.dot(joint.X_AJ.p);
  switch (joint.type) {
    case JointType::kRigid:
      return {OrientationOf(X_BA.R), point(Link::kB, X_BA.p)};
    case JointType::kPrismatic:
      return {direction(Link::kA, l_A), direction(Link::kB, l_B), OrientationOf(X_BA.R),
              point(Link::kB, X_BA.p)};
    case JointType::kSpherical:
      return {point(Link::kA, joint.X_AJ.p), point(Link::kB, joint.X_BJ.p)};
    case JointType::kPlanar:
      return {direction(Link::kA, l_A), direction(Link::kB, l_B), point(Link::kB, X_BA.p)};
    case JointType::kTwoAxis:
      return {direction(Link::kA, joint.X_AJ.R.col(1)), direction(Link::kB, l_B),
              point(Link::kA, joint.X_AJ.p), point(Link::kB, joint.X_BJ.p),
              Named("offset", Kind::kLength, Link::kNeither, Vector3d(joint.offset, 0, 0))};
    default:
      break;
  }
  std::vector<NamedParameter> values = {direction(Link::kA, l_A), direction(Link::kB, l_B),
                                        point(Link::kA, foot_A), point(Link::kB, X_BA * foot_A)};
  if (joint.type == JointType::kScrew) {
    values.push_back(Named("pitch", Kind::kPitch, Link::kNeither, Vector3d(joint.pitch, 0, 0)));
  }
  return values;
}

// What leads from one value to the other: three numbers.
Vector3d Difference(const NamedParameter& from, const NamedParameter& to) {
  if (from.kind != Kind::kOrientation) return (to.value - from.value).head<3>();
  const auto rotation = [](const Eigen::Vector4d& q) {
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  };
  return RotationLog(rotation(to.value) * rotation(from.value).transpose());
}

// The derivative of each parameter's value by the free columns.
std::vector<Row> DerivativesOf(const Joint& joint, const Transform& reference) {
  const int columns = JointParameters(joint.type);
  const std::vector<NamedParameter> center = ValuesOf(joint, reference);
  std::vector<Row> rows(center.size(), Row(3, columns));
  for (int i = 0; i < columns; ++i) {
    const ParameterVector step = kStep * ParameterVector::Unit(columns, i);
    const auto ahead = ValuesOf(Changed(joint, step), reference);
    const auto behind = ValuesOf(Changed(joint, -step), reference);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      rows[k].col(i) = (Difference(center[k], ahead[k]) - Difference(center[k], behind[k])) / (2 * kStep);
    }
  }
  return rows;
}

}  // namespace

std::vector<NamedParameter> NamedParametersOf(const JointFit& fit, const Transform& reference) {
  std::vector<NamedParameter> parameters = ValuesOf(fit.joint, reference);
  const std::vector<Row> rows = DerivativesOf(fit.joint, reference);
  // Leaves of a change what the poses tell nothing about.
  const Eigen::Index columns = fit.information.cols();
  const ParameterMatrix seen = PseudoInverse(fit.information) * fit.information;
  const ParameterMatrix open = ParameterMatrix::Identity(columns, columns) - seen;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Row left = rows[i] * open;
    parameters[i].covariance = rows[i] * fit.covariance * rows[i].transpose();
    parameters[i].determined = left.norm() <= kOpenShare * std::max(1.0, rows[i].norm());
    parameters[i].expected_error = std::sqrt(std::max(0.0, parameters[i].covariance.trace()));
  }
  return parameters;
}

Distance DistanceTo(const Joint& truth, const JointFit& fit, const Transform& reference) {
  const std::vector<NamedParameter> from = ValuesOf(fit.joint, reference);
  const std::vector<NamedParameter> to = ValuesOf(AlignedWith(truth, fit.joint), reference);
  const std::vector<Row> rows = DerivativesOf(fit.joint, reference);
  const int columns = JointParameters(truth.type);
  // The change of the columns that leads there, by least squares: more numbers are named than there are columns.
  ParameterMatrix normal = ParameterMatrix::Zero(columns, columns);
  ParameterVector right = ParameterVector::Zero(columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    normal += rows[i].transpose() * rows[i];
    right += rows[i].transpose() * Difference(from[i], to[i]);
  }
  const ParameterVector change = PseudoInverse(normal) * right;
  Distance distance;
  const ParameterMatrix precision = PseudoInverse(fit.covariance, 1e-12, &distance.freedom);
  distance.squared = change.dot(precision * change);
  return distance;
}

std::vector<Transform> CorrectedPoses(const JointFit& fit) {
  std::vector<Transform> poses;
  poses.reserve(fit.coordinates.size());
  for (const Coordinates& q : fit.coordinates) poses.push_back(PoseAt(fit.joint, q));
  return poses;
}

std::vector<Residual> ResidualsOf(const JointFit& fit, std::span<const Transform> poses) {
  const std::vector<Transform> corrected = CorrectedPoses(fit);
  std::vector<Residual> residuals;
  residuals.reserve(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    residuals.push_back({RotationLog(poses[i].R * corrected[i].R.transpose()), poses[i].p - corrected[i].p});
  }
  return residuals;
}

}  // namespace tact::joint

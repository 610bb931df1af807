#include "robot/joint/joint_jacobian.h"

#include <vector>

namespace tact::joint {
namespace {

// What a parameter changes: a rotation or translation of J in B or in A along an axis, the pitch, the offset.
enum Column : std::uint8_t { kRotateB, kMoveB = 3, kRotateA = 6, kMoveA = 9, kPitch = 12, kOffset = 13 };

struct Columns {
  int count;
  std::array<std::uint8_t, kMostParameters> column;
};

constexpr std::array<Columns, kJointTypes.size()> kColumns = {{
    {6, {0, 1, 2, 3, 4, 5}},                    // rigid: X_BJ
    {7, {0, 1, 2, 3, 4, 6, 7}},                 // prismatic: X_BJ but along z, direction in A
    {9, {0, 1, 3, 4, 6, 7, 9, 10, 11}},         // revolute: line in B, line in A, where along it
    {10, {0, 1, 3, 4, 6, 7, 9, 10, 11, 12}},    // screw: the same and the pitch
    {8, {0, 1, 3, 4, 6, 7, 9, 10}},             // cylindrical: line in B, line in A
    {6, {3, 4, 5, 9, 10, 11}},                  // spherical: point in B, point in A
    {5, {0, 1, 6, 7, 11}},                      // planar: normal in B, plane in A
    {11, {0, 1, 3, 4, 5, 6, 8, 9, 10, 11, 13}}  // two-axis: z in B and a point, y in A and a point, offset
}};

const Columns& ColumnsOf(JointType type) { return kColumns[static_cast<std::size_t>(type)]; }

}  // namespace

int JointParameters(JointType type) { return ColumnsOf(type).count; }

Vector6 PoseError(const Joint& joint, const Coordinates& q, const Transform& X_BA) {
  const Transform model = PoseAt(joint, q);
  const Eigen::Matrix3d R_JB = joint.X_BJ.R.transpose();
  Vector6 error;
  error << R_JB * RotationLog(X_BA.R * model.R.transpose()), R_JB * (X_BA.p - model.p);
  return error;
}

JointJacobian JacobianAt(const Joint& joint, const Coordinates& q) {
  using Eigen::Vector3d;
  const Transform M = MotionOf(joint, q);
  const Vector3d p_JA = joint.X_AJ.Inverse().p;  // A's origin in J as fixed in A
  const Vector3d arm = M * p_JA;                 // and as fixed in B
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

  JointJacobian jacobian;
  const Columns& columns = ColumnsOf(joint.type);
  jacobian.parameters.resize(6, columns.count);
  for (int i = 0; i < columns.count; ++i) {
    const std::uint8_t column = columns.column[static_cast<std::size_t>(i)];
    const Vector3d axis = column < kPitch ? Vector3d(Vector3d::Unit(column % 3)) : Vector3d(x);
    Vector3d turn = Vector3d::Zero(), move = Vector3d::Zero();
    if (column < kMoveB) {
      turn = axis;
      move = axis.cross(arm);
    } else if (column < kRotateA) {
      move = axis;
    } else if (column < kMoveA) {
      turn = -(M.R * axis);
      move = -(M.R * axis.cross(p_JA));
    } else if (column < kPitch) {
      move = -(M.R * axis);
    } else if (column == kPitch) {
      move = q[0] * z;
    } else {
      move = Vector3d(std::cos(q[0]), std::sin(q[0]), 0);
    }
    jacobian.parameters.col(i) << turn, move;
  }

  jacobian.coordinates.resize(6, JointDof(joint.type));
  const auto turning = [&](int i, const Vector3d& axis, const Vector3d& center) {
    jacobian.coordinates.col(i) << axis, axis.cross(arm - center);
  };
  const auto moving = [&](int i, const Vector3d& axis) {
    jacobian.coordinates.col(i) << Vector3d::Zero(), axis;
  };
  switch (joint.type) {
    case JointType::kRigid:
      break;
    case JointType::kPrismatic:
      moving(0, z);
      break;
    case JointType::kRevolute:
      turning(0, z, Vector3d::Zero());
      break;
    case JointType::kScrew:
      turning(0, z, Vector3d::Zero());
      jacobian.coordinates(5, 0) += joint.pitch;
      break;
    case JointType::kCylindrical:
      turning(0, z, Vector3d::Zero());
      moving(1, z);
      break;
    case JointType::kSpherical:
      for (int i = 0; i < 3; ++i) turning(i, Vector3d::Unit(i), Vector3d::Zero());
      break;
    case JointType::kPlanar:
      turning(0, z, M.p);
      moving(1, x);
      moving(2, y);
      break;
    case JointType::kTwoAxis:
      turning(0, z, Vector3d::Zero());
      turning(1, Vector3d(-std::sin(q[0]), std::cos(q[0]), 0), M.p);
      break;
  }
  return jacobian;
}

Joint Changed(const Joint& joint, const ParameterVector& change) {
  Eigen::Matrix<double, 14, 1> all = Eigen::Matrix<double, 14, 1>::Zero();
  const Columns& columns = ColumnsOf(joint.type);
  for (int i = 0; i < columns.count; ++i) all[columns.column[static_cast<std::size_t>(i)]] = change[i];
  Joint changed = joint;
  const auto turned = [](const Transform& X, const Eigen::Vector3d& turn, const Eigen::Vector3d& move) {
    return Transform{X.R * RotationExp(turn), X.p + X.R * move};
  };
  changed.X_BJ = turned(joint.X_BJ, all.segment<3>(kRotateB), all.segment<3>(kMoveB));
  changed.X_AJ = turned(joint.X_AJ, all.segment<3>(kRotateA), all.segment<3>(kMoveA));
  changed.pitch += all[kPitch];
  changed.offset += all[kOffset];
  return changed;
}

Coordinates Changed(const Joint& joint, const Coordinates& q, const Eigen::Vector3d& change) {
  if (joint.type != JointType::kSpherical) return q + change;
  return RotationLog(RotationExp(change) * RotationExp(q));
}

}  // namespace tact::joint

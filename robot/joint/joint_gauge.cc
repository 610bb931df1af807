#include "robot/joint/joint_gauge.h"

#include <numbers>

#include "robot/joint/likelihood_climb.h"

namespace tact::joint {
namespace {

using Eigen::Vector3d;

Joint TurnedBy(Joint joint, const Vector3d& axis) {
  const Eigen::Matrix3d half_turn = RotationExp(std::numbers::pi * axis);
  joint.X_BJ.R *= half_turn;
  joint.X_AJ.R *= half_turn;
  return joint;
}

// The axis that tells one sign from the other.
Vector3d AxisOf(const Joint& joint) { return joint.X_BJ.R.col(2); }

}  // namespace

Joint ZeroedAt(const Joint& joint, const Coordinates& q) {
  Joint zeroed = joint;
  const Transform M = MotionOf(joint, q);
  if (joint.type == JointType::kTwoAxis) {
    // Rz(q1) T(o) Ry(q2): each angle goes to the side where its axis is fixed.
    zeroed.X_BJ.R = joint.X_BJ.R * RotationExp(q[0] * Vector3d::UnitZ());
    zeroed.X_AJ.R = joint.X_AJ.R * RotationExp(-q[1] * Vector3d::UnitY());
    return zeroed;
  }
  zeroed.X_AJ = joint.X_AJ * M.Inverse();
  return zeroed;
}

Joint Reversed(const Joint& joint) {
  if (joint.type == JointType::kRigid || joint.type == JointType::kSpherical) return joint;
  return TurnedBy(joint, Vector3d::UnitX());
}

Joint OffsetReversed(const Joint& joint) {
  if (joint.type != JointType::kTwoAxis) return joint;
  // T(o) Ry(q2) = T(o) Rz(pi) Ry(-q2) Rz(pi), and T(o) Rz(pi) = Rz(pi) T(-o).
  Joint reversed = joint;
  reversed.X_AJ.R = joint.X_AJ.R * RotationExp(std::numbers::pi * Vector3d::UnitZ());
  reversed.X_BJ.R = joint.X_BJ.R * RotationExp(std::numbers::pi * Vector3d::UnitZ());
  reversed.offset = -joint.offset;
  return reversed;
}

Joint InNormalForm(const Joint& joint, std::span<const Transform> poses) {
  Joint normal = joint.offset < 0 ? OffsetReversed(joint) : joint;
  normal = ZeroedAt(normal, CoordinatesNear(normal, poses.front()));
  double farthest = 0;
  for (const Coordinates& q : CoordinatesAlong(normal, poses)) {
    if (std::abs(q[0]) > std::abs(farthest)) farthest = q[0];
  }
  return farthest < 0 ? Reversed(normal) : normal;
}

Joint AlignedWith(const Joint& joint, const Joint& other) {
  Joint aligned = joint.offset < 0 ? OffsetReversed(joint) : joint;
  if (AxisOf(aligned).dot(AxisOf(other)) < 0) aligned = Reversed(aligned);
  // Where the offset is nearly none, its sign says nothing: the second axis decides.
  if (joint.type == JointType::kTwoAxis && aligned.X_AJ.R.col(1).dot(other.X_AJ.R.col(1)) < 0) {
    aligned = OffsetReversed(aligned);
  }
  return aligned;
}

}  // namespace tact::joint

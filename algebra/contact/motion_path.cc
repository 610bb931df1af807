#include "algebra/contact/motion_path.h"

#include "algebra/error.h"

namespace tact::algebra {

MotionPath MotionPath::Line(const Vector3& direction) {
  if (direction.IsZero()) throw PreconditionError("a line of motion needs a direction that is not zero");
  return {Kind::kLine, direction, {}};
}

MotionPath MotionPath::Rotation(const Vector3& point, const Vector3& axis) {
  if (axis.IsZero()) throw PreconditionError("a rotation needs an axis that is not zero");
  return {Kind::kRotation, axis, point};
}

Pose MotionPath::At(const Rational& s) const {
  if (kind == Kind::kLine) return {{}, s * vector};
  const Vector3 v = s * vector;
  const auto turn = algebra::Rotation::FromQuaternion(1, v.x, v.y, v.z);
  return {turn, center - turn * center};
}

}  // namespace tact::algebra

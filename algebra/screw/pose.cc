#include "algebra/screw/pose.h"

#include "algebra/error.h"

namespace tact::algebra {

Rotation Rotation::FromQuaternion(const Rational& w, const Rational& x, const Rational& y,
                                  const Rational& z) {
  const Rational norm = w * w + x * x + y * y + z * z;
  if (norm.sign() == 0) throw PreconditionError("a zero quaternion is no rotation");
  const Rational s = Rational(2) / norm;
  return {{{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
            {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
            {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}}};
}

Vector3 Rotation::operator*(const Vector3& v) const {
  return {Dot(rows[0], v), Dot(rows[1], v), Dot(rows[2], v)};
}

Rotation Rotation::Transpose() const {
  Rotation t;
  for (int i = 0; i < 3; ++i) t.rows[i] = {rows[0][i], rows[1][i], rows[2][i]};
  return t;
}

Rotation Rotation::operator*(const Rotation& other) const {
  const Rotation columns = other.Transpose();
  Rotation product;
  for (int i = 0; i < 3; ++i) {
    product.rows[i] = {Dot(rows[i], columns.rows[0]), Dot(rows[i], columns.rows[1]),
                       Dot(rows[i], columns.rows[2])};
  }
  return product;
}

bool IsRotation(const Rotation& r) {
  return r * r.Transpose() == Rotation{} && Dot(Cross(r.rows[0], r.rows[1]), r.rows[2]) == Rational(1);
}

Vector3 Pose::operator*(const Vector3& point) const { return rotation * point + translation; }

Pose Pose::operator*(const Pose& other) const {
  return {rotation * other.rotation, rotation * other.translation + translation};
}

Pose Pose::Inverse() const {
  const Rotation r = rotation.Transpose();
  return {r, -(r * translation)};
}

}  // namespace tact::algebra

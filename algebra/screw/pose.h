/// @file
/// Exact rigid poses: a rational rotation matrix and a rational translation.
/// Frames  X_AB maps coordinates in B to coordinates in A: p_A = R_AB p_B + p_AB.
/// Units   the translation has the length unit of the points it moves.
/// Exact   any non-zero rational quaternion (it need not be unit) gives a rational rotation.
#pragma once

#include <array>

#include "algebra/screw/vector3.h"

namespace tact::algebra {

/// A rotation as a matrix of rationals; rows[i] is row i.
struct Rotation {
  std::array<Vector3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// R = the rotation of the quaternion w + xi + yj + zk over its norm. PreconditionError: all four zero.
  static Rotation FromQuaternion(const Rational& w, const Rational& x, const Rational& y, const Rational& z);
  Vector3 operator*(const Vector3& v) const;
  Rotation Transpose() const;
  Rotation operator*(const Rotation& other) const;
  friend bool operator==(const Rotation& a, const Rotation& b) = default;
};

/// Whether R^T R is the identity and the determinant is one, exactly.
bool IsRotation(const Rotation& r);

struct Pose {
  Rotation rotation;
  Vector3 translation;

  Vector3 operator*(const Vector3& point) const;
  Pose operator*(const Pose& other) const;
  Pose Inverse() const;
  friend bool operator==(const Pose& a, const Pose& b) = default;
};

}  // namespace tact::algebra

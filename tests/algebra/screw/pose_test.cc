#include "algebra/screw/pose.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/error.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

using Quaternion = std::array<Rational, 4>;

Vector3 SmallVector() { return {Uniform(-9, 10), Uniform(-9, 10), Uniform(-9, 10)}; }

Quaternion SmallQuaternion() {
  for (;;) {
    const Quaternion q{Uniform(-4, 5), Uniform(-4, 5), Uniform(-4, 5), Uniform(-4, 5)};
    if (q != Quaternion{}) return q;
  }
}

Rotation RotationOf(const Quaternion& q) { return Rotation::FromQuaternion(q[0], q[1], q[2], q[3]); }

Quaternion Product(const Quaternion& p, const Quaternion& q) {
  const Vector3 a{p[1], p[2], p[3]}, b{q[1], q[2], q[3]};
  const Vector3 v = p[0] * b + q[0] * a + Cross(a, b);
  return {p[0] * q[0] - Dot(a, b), v.x, v.y, v.z};
}

Pose SmallPose() { return {RotationOf(SmallQuaternion()), SmallVector()}; }

TEST(Rotation, AQuarterAboutZTakesXToY) {
  const Rotation r = Rotation::FromQuaternion(1, 0, 0, 1);
  EXPECT_EQ(r * (Vector3{1, 0, 0}), (Vector3{0, 1, 0}));
  EXPECT_EQ(r * (Vector3{0, 1, 0}), (Vector3{-1, 0, 0}));
}

TEST(Rotation, TheTangentOfHalfTheAngleIsTheQuaternions) {  // 2, 1: cosine 3/5, sine 4/5
  EXPECT_EQ(Rotation::FromQuaternion(2, 0, 0, 1) * (Vector3{5, 0, 7}), (Vector3{3, 4, 7}));
}

TEST(Rotation, AZeroQuaternionIsRefused) {
  EXPECT_THROW(Rotation::FromQuaternion(0, 0, 0, 0), PreconditionError);
}

TEST(Rotation, MirrorsShearsAndScalingsAreNone) {
  EXPECT_TRUE(IsRotation({}));
  EXPECT_FALSE(IsRotation({{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}}));
  EXPECT_FALSE(IsRotation({{{{1, 1, 0}, {0, 1, 0}, {0, 0, 1}}}}));
  EXPECT_FALSE(IsRotation({{{{2, 0, 0}, {0, Rational(1, 2), 0}, {0, 0, 1}}}}));
}

RC_GTEST_PROP(RotationLaw, QuaternionsMultiplyAsRotationsDo, ()) {
  const Quaternion p = SmallQuaternion(), q = SmallQuaternion();
  RC_ASSERT(RotationOf(Product(p, q)) == RotationOf(p) * RotationOf(q));
  const Rational s(Integer(Uniform(1, 9)), Integer(-7));
  RC_ASSERT(RotationOf({s * p[0], s * p[1], s * p[2], s * p[3]}) == RotationOf(p));
  const Vector3 axis{p[1], p[2], p[3]};
  RC_ASSERT(RotationOf(p) * axis == axis);
}

RC_GTEST_PROP(RotationLaw, KeepsLengthsAndHandedness, ()) {
  const Rotation r = RotationOf(SmallQuaternion());
  const Vector3 a = SmallVector(), b = SmallVector();
  RC_ASSERT(IsRotation(r));
  RC_ASSERT(Dot(r * a, r * b) == Dot(a, b));
  RC_ASSERT(Cross(r * a, r * b) == r * Cross(a, b));
  RC_ASSERT(r.Transpose() * (r * a) == a);
}

RC_GTEST_PROP(PoseLaw, PosesAreAGroupThatActsOnPoints, ()) {
  const Pose X = SmallPose(), Y = SmallPose(), Z = SmallPose();
  const Vector3 p = SmallVector();
  RC_ASSERT((X * Y) * p == X * (Y * p));
  RC_ASSERT((X * Y) * Z == X * (Y * Z));
  RC_ASSERT(X * Pose{} == X);
  RC_ASSERT(Pose{} * X == X);
  RC_ASSERT(X * X.Inverse() == Pose{});
  RC_ASSERT(X.Inverse() * X == Pose{});
}

}  // namespace
}  // namespace tact::algebra

#include "robot/planning/rotation_split.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace tact::planning {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Small whole quaternions: half turns and equal axes come up often.
Matrix3d AnyRotation() {
  const auto any = [] { return static_cast<double>(*rc::gen::inRange(-4, 5)); };
  Eigen::Quaterniond q(any(), any(), any(), any());
  if (q.norm() == 0) q.w() = 1;
  return q.normalized().toRotationMatrix();
}

Vector3d AnyAxis() {
  Vector3d v(*rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4));
  return v.isZero() ? Vector3d(0, 0, 1) : Vector3d(v.normalized());
}

Matrix3d About(const Vector3d& axis, double angle) { return joint::RotationExp(angle * axis); }

RC_GTEST_PROP(RotationSplit, AboutAndAcrossMakeUpTheRotationInBothOrders, ()) {
  const Matrix3d D = AnyRotation();
  const Vector3d z = AnyAxis();
  const AboutAndAcross split = SplitAboutAndAcross(D, z);
  RC_ASSERT((About(z, split.about) * split.across_first.Rotation() - D).norm() < 1e-12);
  RC_ASSERT((split.across_last.Rotation() * About(z, split.about) - D).norm() < 1e-12);
  RC_ASSERT(std::abs(split.across_first.axis.dot(z)) < 1e-12);
  RC_ASSERT(std::abs(split.across_last.axis.dot(z)) < 1e-12);
  RC_ASSERT(std::abs(split.about) <= std::numbers::pi);
}

// Brute: whatever is turned about z beforehand, what is left is no smaller [thesis, A.4.2, case 2].
RC_GTEST_PROP(RotationSplit, TheTurnAcrossIsTheSmallestUpToTurnsAboutTheAxis, ()) {
  const Matrix3d D = AnyRotation();
  const Vector3d z = AnyAxis();
  const double angle = std::abs(SplitAboutAndAcross(D, z).across_first.angle);
  for (int i = 0; i < 60; ++i)
    RC_ASSERT(joint::RotationLog(About(z, 2 * std::numbers::pi * i / 60) * D).norm() >= angle - 1e-9);
}

RC_GTEST_PROP(RotationSplit, AProductOfTwoTurnsIsTakenApart, ()) {
  const Vector3d l = AnyAxis(), r = AnyAxis();
  const double left = *rc::gen::inRange(-6, 7) / 2.0, right = *rc::gen::inRange(-6, 7) / 2.0;
  const Matrix3d D = About(l, left) * About(r, right);
  const auto split = SplitIntoTwo(D, r, l);
  RC_ASSERT(split.has_value());
  RC_ASSERT((split->second.Rotation() * split->first.Rotation() - D).norm() < 1e-9);
}

// A quarter turn about x is no product of turns about y and z: w x = 1/2, y z = 0 (thesis.A.4.2.case-3).
TEST(RotationSplit, WhatIsNoProductOfTheTwoIsRefused) {
  const Matrix3d quarter = About(Vector3d::UnitX(), std::numbers::pi / 2);
  EXPECT_FALSE(SplitIntoTwo(quarter, Vector3d::UnitZ(), Vector3d::UnitY()));
}

// By hand: (2, 2, 1)/3 is atan(1/2) off the plane z = 0 about y.
TEST(RotationSplit, AnEdgeIsTurnedIntoAPlaneByTheSmallerAngle) {
  const Vector3d n(0, 0, 1), l(1, 0, 0);
  for (const Vector3d& u : {Vector3d(2, 2, 1), Vector3d(-2, 2, 1), Vector3d(2, -2, -1)}) {
    const Turn turn = TurnIntoPlane(u / 3, n, n.cross(l));
    EXPECT_NEAR(std::abs(turn.angle), std::atan(0.5), 1e-15);
    EXPECT_NEAR(n.dot(turn.Rotation() * u), 0, 1e-15);
  }
}

}  // namespace
}  // namespace tact::planning

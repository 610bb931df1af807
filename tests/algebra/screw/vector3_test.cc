#include "algebra/screw/vector3.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

Vector3 SmallVector() {
  const auto entry = [] { return Rational(Integer(Uniform(-9, 10)), Integer(Uniform(1, 7))); };
  return {entry(), entry(), entry()};
}

TEST(Vector3, PrimitiveHasWholeEntriesWithoutCommonFactor) {
  EXPECT_EQ(Primitive({Rational(2, 3), Rational(-4, 9), 0}), (Vector3{3, -2, 0}));
  EXPECT_EQ(Primitive({-6, -9, -15}), (Vector3{-2, -3, -5}));
  EXPECT_EQ(Primitive({0, 0, Rational(-1, 7)}), (Vector3{0, 0, -1}));
  EXPECT_EQ(Primitive({0, 0, 0}), (Vector3{0, 0, 0}));
}

TEST(Vector3, OrderIsLexicographic) {
  EXPECT_LT((Vector3{0, 9, 9}), (Vector3{1, 0, 0}));
  EXPECT_LT((Vector3{1, 0, 9}), (Vector3{1, 1, 0}));
  EXPECT_LT((Vector3{1, 1, 0}), (Vector3{1, 1, Rational(1, 9)}));
}

TEST(Vector3, CrossFollowsTheRightHand) {
  EXPECT_EQ(Cross({1, 0, 0}, {0, 1, 0}), (Vector3{0, 0, 1}));
  EXPECT_EQ(Cross({0, 1, 0}, {0, 0, 1}), (Vector3{1, 0, 0}));
  EXPECT_EQ(Cross({2, 3, 4}, {5, 6, 7}), (Vector3{-3, 6, -3}));
}

TEST(Vector3, PrintsItsEntries) {
  EXPECT_EQ(ToString(Vector3{1, Rational(-1, 2), Rational(1, 3)}), "(1, -0.5, 1/3)");
}

RC_GTEST_PROP(Vector3Law, CrossAndDot, ()) {
  const Vector3 a = SmallVector(), b = SmallVector(), c = SmallVector();
  RC_ASSERT(Dot(Cross(a, b), a) == Rational(0));
  RC_ASSERT(Cross(a, b) == -Cross(b, a));
  RC_ASSERT(Cross(a, Cross(b, c)) == Dot(a, c) * b - Dot(a, b) * c);
  RC_ASSERT(Dot(Cross(a, b), Cross(a, b)) + Dot(a, b) * Dot(a, b) == Dot(a, a) * Dot(b, b));
  RC_ASSERT(Parallel(a, Rational(-3, 2) * a));
}

RC_GTEST_PROP(Vector3Law, PositiveMultiplesHaveOnePrimitive, ()) {
  const Vector3 a = SmallVector();
  const Rational s(Integer(Uniform(1, 99)), Integer(Uniform(1, 99)));
  RC_ASSERT(Primitive(s * a) == Primitive(a));
  RC_ASSERT(Primitive(-a) == -Primitive(a));
  RC_ASSERT(Dot(Primitive(a), a) >= Rational(0));
  RC_ASSERT(Parallel(Primitive(a), a));
}

}  // namespace
}  // namespace tact::algebra

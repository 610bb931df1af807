#include "algebra/exact/quadratic.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "algebra/error.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

TEST(Quadratic, RationalRootsInsideAreFoundAndTheEndsAreNotInside) {
  const auto half = RootsInside({-1, 2, 0});
  ASSERT_EQ(half.size(), 1u);
  EXPECT_EQ(half[0].center, Rational(1, 2));
  EXPECT_TRUE(half[0].is_rational());
  EXPECT_TRUE(RootsInside({0, 1, 0}).empty());
  EXPECT_TRUE(RootsInside({-1, 1, 0}).empty());
  EXPECT_TRUE(RootsInside({0, 1, -1}).empty());
  EXPECT_TRUE(RootsInside({7, 0, 0}).empty());
  const auto two = RootsInside({Rational(2, 9), -1, 1});  // (s - 1/3) (s - 2/3)
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].center, Rational(1, 3));
  EXPECT_EQ(two[1].center, Rational(2, 3));
}

TEST(Quadratic, ADoubleRootIsOneRoot) {
  const auto roots = RootsInside({1, -4, 4});
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_EQ(roots[0].center, Rational(1, 2));
  EXPECT_EQ(SignInside({1, -4, 4}), 0);
}

TEST(Quadratic, AnIrrationalRootHasExactSigns) {
  const auto roots = RootsInside({-1, 0, 2});  // 1/sqrt(2)
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_FALSE(roots[0].is_rational());
  EXPECT_EQ(SignAt({-1, 0, 2}, roots[0]), 0);
  EXPECT_EQ(SignAt({-2, 0, 4}, roots[0]), 0);
  EXPECT_EQ(SignAt({Rational(-7071067811865475, 10000000000000000), 1, 0}, roots[0]), 1);
  EXPECT_EQ(SignAt({Rational(-7071067811865476, 10000000000000000), 1, 0}, roots[0]), -1);
  EXPECT_NEAR(ToDouble(roots[0]), std::sqrt(0.5), 1e-12);
}

TEST(Quadratic, EveryNumberIsARootOfZeroWhichIsRefused) {
  EXPECT_THROW(RootsInside({0, 0, 0}), PreconditionError);
  EXPECT_EQ(SignInside({0, 0, 0}), 0);
}

Quadratic AnyQuadratic() {
  const auto any = [] { return Rational(Integer(Uniform(-9, 10)), Integer(Uniform(1, 4))); };
  return {any(), any(), any()};
}

// Twin: the sign changes and zeros seen on a fine grid are between and at the roots found.
RC_GTEST_PROP(Quadratic, SignsOnAGridChangeAtTheRootsOnly, ()) {
  const Quadratic p = AnyQuadratic();
  RC_PRE(!p.IsZero());
  const auto roots = RootsInside(p);
  for (const QuadraticRoot& root : roots) RC_ASSERT(SignAt(p, root) == 0);
  constexpr int kSteps = 60;
  for (int i = 1; i + 1 < kSteps; ++i) {
    const Rational s(i, kSteps), t(i + 1, kSteps);
    int between = 0;
    bool at = false;
    for (const QuadraticRoot& root : roots) {
      between += Compare(root, {s, 0, 0}) > 0 && Compare(root, {t, 0, 0}) < 0;
      at = at || Compare(root, {s, 0, 0}) == 0;
    }
    RC_ASSERT(at == (p.At(s).sign() == 0));
    if (p.At(s).sign() * p.At(t).sign() < 0) RC_ASSERT(between == 1);
    if (between == 1 && p.At(s).sign() * p.At(t).sign() > 0)
      RC_ASSERT(p.c1 * p.c1 == Rational(4) * p.c0 * p.c2);
  }
}

RC_GTEST_PROP(Quadratic, BernsteinCoefficientsEncloseItsValues, ()) {
  const Quadratic p = AnyQuadratic();
  const auto b = p.Bernstein();
  for (int i = 0; i <= 8; ++i) {
    const Rational value = p.At(Rational(i, 8));
    RC_ASSERT(value >= std::min({b[0], b[1], b[2]}));
    RC_ASSERT(value <= std::max({b[0], b[1], b[2]}));
  }
}

RC_GTEST_PROP(Quadratic, ComparingRootsAgreesWithDoubles, ()) {
  const Quadratic p = AnyQuadratic(), q = AnyQuadratic();
  RC_PRE(!p.IsZero() && !q.IsZero());
  for (const QuadraticRoot& a : RootsInside(p)) {
    for (const QuadraticRoot& b : RootsInside(q)) {
      const double difference = ToDouble(a) - ToDouble(b);
      const int sign = Compare(a, b);
      RC_ASSERT(sign == -Compare(b, a));
      if (std::abs(difference) > 1e-9) RC_ASSERT(sign == (difference > 0 ? 1 : -1));
      if (sign == 0) RC_ASSERT(std::abs(difference) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace tact::algebra

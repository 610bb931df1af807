#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/cone/cone.h"
#include "algebra/error.h"
#include "tests/algebra/cone/any_cone.h"

namespace tact::algebra {
namespace {

// Whether the evidence says what it has to say; `inside` becomes what it says.
bool IsEvidence(const GeneratorCone& cone, const IntegerVector& x, bool& inside) {
  const auto result = FindCombination(cone, x);
  inside = std::holds_alternative<Combination>(result);
  if (!inside) {
    const IntegerVector& normal = std::get<SeparatingNormal>(result).normal;
    bool right = Dot(normal, x).sign() < 0;
    for (size_t i = 0; i < cone.lines.rows; ++i) right = right && Dot(normal, cone.lines.row(i)).sign() == 0;
    for (size_t i = 0; i < cone.rays.rows; ++i) right = right && Dot(normal, cone.rays.row(i)).sign() >= 0;
    return right;
  }
  const Combination& weights = std::get<Combination>(result);
  std::vector<Rational> sum(x.size());
  for (size_t j = 0; j < x.size(); ++j) {
    for (size_t i = 0; i < cone.lines.rows; ++i)
      sum[j] += weights.line_weights[i] * Rational(cone.lines(i, j));
    for (size_t i = 0; i < cone.rays.rows; ++i) sum[j] += weights.ray_weights[i] * Rational(cone.rays(i, j));
    if (sum[j] != Rational(x[j])) return false;
  }
  for (const Rational& weight : weights.ray_weights) {
    if (weight.sign() < 0) return false;
  }
  return true;
}

TEST(ConeMembership, TheViolatedRowIsNamed) {
  const HalfspaceCone cone(IntegerMatrix::FromRows({{1, 0, 0}, {0, 1, 0}}, 3),
                           IntegerMatrix::FromRows({{0, 0, 1}}, 3));
  EXPECT_EQ(FindViolatedRow(cone, IntegerVector{1, 2, 0}), std::nullopt);
  EXPECT_EQ(FindViolatedRow(cone, IntegerVector{1, -2, 5}), (ViolatedRow{1, false}));
  EXPECT_EQ(FindViolatedRow(cone, IntegerVector{1, 2, 5}), (ViolatedRow{0, true}));
}

TEST(ConeMembership, RaysThatSpanALineNeedNoLine) {
  const GeneratorCone line{IntegerMatrix(0, 2), IntegerMatrix::FromRows({{1, 0}, {-1, 0}}, 2)};
  bool inside = false;
  EXPECT_TRUE(IsEvidence(line, {-3, 0}, inside));
  EXPECT_TRUE(inside);
  EXPECT_TRUE(IsEvidence(line, {-3, 1}, inside));
  EXPECT_FALSE(inside);
}

TEST(ConeMembership, VectorsOfAnotherLengthAreRefused) {
  EXPECT_THROW(FindViolatedRow(HalfspaceCone(IntegerMatrix::Identity(3)), IntegerVector{1}),
               PreconditionError);
  EXPECT_THROW(FindCombination({IntegerMatrix(0, 2), IntegerMatrix::Identity(2)}, IntegerVector{1}),
               PreconditionError);
}

RC_GTEST_PROP(ConeMembershipTwin, EvidenceIsRightAndAgreesWithTheFacets, ()) {
  const GeneratorCone cone = AnyGeneratorCone(9, 1, 6);
  IntegerVector x(cone.ambient_dimension());
  const bool surely_inside = Uniform(0, 3) == 0;
  if (surely_inside) {
    for (size_t i = 0; i < cone.rays.rows; ++i) {
      const Integer weight(std::max(0, Uniform(-2, 3)));
      for (size_t j = 0; j < x.size(); ++j) x[j] += weight * cone.rays(i, j);
    }
  } else {
    for (Integer& entry : x) entry = Uniform(-3, 4);
  }
  bool inside = false;
  RC_ASSERT(IsEvidence(cone, x, inside));
  RC_ASSERT(inside == !FindViolatedRow(Facets(cone), x).has_value());
  RC_ASSERT(inside || !surely_inside);
}

}  // namespace
}  // namespace tact::algebra

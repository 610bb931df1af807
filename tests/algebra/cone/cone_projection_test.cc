#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/cone/cone.h"
#include "algebra/error.h"
#include "tests/algebra/cone/any_cone.h"
#include "tests/algebra/cone/fourier_motzkin.h"

namespace tact::algebra {
namespace {

RationalRow ToRationals(std::span<const Integer> row) { return {row.begin(), row.end()}; }

// Whether some point of the cone has these coordinates.
bool Reaches(const HalfspaceCone& cone, std::span<const size_t> coordinates, std::span<const Integer> x) {
  // Homogeneous: one more variable s > 0 with x_c = s target.
  const size_t n = cone.ambient_dimension();
  FourierMotzkin system;
  const auto widened = [&](std::span<const Integer> row) {
    RationalRow wide = ToRationals(row);
    wide.emplace_back(0);
    return wide;
  };
  for (size_t i = 0; i < cone.inequalities.rows; ++i) system.NonNegative(widened(cone.inequalities.row(i)));
  for (size_t i = 0; i < cone.equalities.rows; ++i) system.Equal(widened(cone.equalities.row(i)));
  for (size_t i = 0; i < coordinates.size(); ++i) {
    RationalRow row(n + 1);
    row[coordinates[i]] = 1;
    row[n] = -Rational(x[i]);
    system.Equal(row);
  }
  RationalRow positive(n + 1);
  positive[n] = 1;
  system.Positive(positive);
  return system.Feasible(n + 1);
}

TEST(ConeProjection, AShadowOfTheOrthantTurnedIsAHalfPlane) {
  // Rays (1, 0, 0), (-1, 1, 0), (0, 0, 1) seen along z.
  const GeneratorCone cone{IntegerMatrix(0, 3),
                           IntegerMatrix::FromRows({{1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}}, 3)};
  const std::vector<size_t> xy = {0, 1};
  const ConeForms shadow = Project(cone, xy);
  EXPECT_EQ(shadow.facets.inequalities, IntegerMatrix::FromRows({{0, 1}}, 2));
  EXPECT_EQ(shadow.generators.lines, IntegerMatrix::FromRows({{1, 0}}, 2));
  EXPECT_EQ(shadow.generators.rays, IntegerMatrix::FromRows({{0, 1}}, 2));
}

TEST(ConeProjection, AlongEverythingIsAPoint) {
  const ConeForms point = Project(HalfspaceCone(IntegerMatrix::Identity(3)), {});
  EXPECT_EQ(point.generators.rays.rows + point.generators.lines.rows, 0u);
  EXPECT_EQ(point.facets.ambient_dimension(), 0u);
}

TEST(ConeProjection, AMissingCoordinateIsRefused) {
  const std::vector<size_t> none_such = {3};
  EXPECT_THROW(Project(HalfspaceCone(IntegerMatrix::Identity(3)), none_such), PreconditionError);
}

RC_GTEST_PROP(ConeProjectionBrute, ContainsAPointIfAndOnlyIfSomePreimageDoes, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(6, 2, 5);
  std::vector<size_t> coordinates;
  for (size_t j = 0; j < cone.ambient_dimension(); ++j) {
    if (Uniform(0, 2) == 0) coordinates.push_back(j);
  }
  const ConeForms shadow = Project(cone, coordinates);
  for (int trial = 0; trial < 4; ++trial) {
    IntegerVector x;
    for (size_t i = 0; i < coordinates.size(); ++i) x.push_back(Integer(Uniform(-2, 3)));
    RC_ASSERT(!FindViolatedRow(shadow.facets, x).has_value() == Reaches(cone, coordinates, x));
  }
}

RC_GTEST_PROP(ConeProjectionLaw, OntoAllCoordinatesIsTheCone, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(10, 1, 6);
  std::vector<size_t> coordinates(cone.ambient_dimension());
  for (size_t j = 0; j < coordinates.size(); ++j) coordinates[j] = j;
  const ConeForms same = Project(cone, coordinates);
  RC_ASSERT(same.generators == Generators(cone).cone);
  RC_ASSERT(Generators(same.facets).cone == same.generators);
}

}  // namespace
}  // namespace tact::algebra

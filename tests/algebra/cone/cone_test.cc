#include "algebra/cone/cone.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"
#include "tests/algebra/cone/any_cone.h"

namespace tact::algebra {
namespace {

IntegerMatrix Rows(const std::vector<IntegerVector>& rows, size_t columns) {
  return IntegerMatrix::FromRows(rows, columns);
}

// The extreme rays by their definition: rows that are tight on one have the rank that leaves a line over the
// lineality space.
IntegerMatrix BruteRays(const HalfspaceCone& cone) {
  const IntegerMatrix& a = cone.inequalities;
  IntegerMatrix all = cone.equalities;
  all.AppendRows(a);
  const EchelonBasis lineality = RowSpace(NullSpace(all));
  std::set<IntegerVector> rays;
  for (size_t bits = 0; bits < size_t{1} << a.rows; ++bits) {
    IntegerMatrix tight = cone.equalities;
    tight.AppendRows(lineality.vectors);
    for (size_t i = 0; i < a.rows; ++i) {
      if ((bits >> i & 1) != 0) tight.AppendRow(a.row(i));
    }
    const IntegerMatrix candidates = NullSpace(tight);
    if (candidates.rows != 1) continue;
    for (const int sign : {1, -1}) {
      IntegerVector ray = candidates.RowVector(0);
      for (Integer& entry : ray) entry *= Integer(sign);
      if (!FindViolatedRow(cone, ray)) rays.insert(ReduceModulo(lineality, ray));
    }
  }
  return Rows({rays.begin(), rays.end()}, cone.ambient_dimension());
}

TEST(Cone, OrthantHasTheUnitRays) {
  const ConeGenerators orthant = Generators(HalfspaceCone(IntegerMatrix::Identity(3)));
  EXPECT_EQ(orthant.cone.lines.rows, 0u);
  EXPECT_EQ(orthant.cone.rays, Rows({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 3));
  EXPECT_EQ(orthant.tight[0].ToVector(), (std::vector<size_t>{0, 1}));
}

TEST(Cone, HalfSpaceHasOneRayModuloItsLines) {
  const ConeGenerators half = Generators(HalfspaceCone(Rows({{1, 1}}, 2)));
  EXPECT_EQ(half.cone.lines, Rows({{1, -1}}, 2));
  EXPECT_EQ(half.cone.rays, Rows({{0, 1}}, 2));  // (1, 1) less half the line
}

TEST(Cone, WithoutRowsItIsTheWholeSpace) {
  const ConeGenerators space = Generators(HalfspaceCone(IntegerMatrix(0, 4)));
  EXPECT_EQ(space.cone.lines, IntegerMatrix::Identity(4));
  EXPECT_EQ(space.cone.rays, IntegerMatrix(0, 4));
  EXPECT_EQ(Facets(space.cone), HalfspaceCone(IntegerMatrix(0, 4)));
}

TEST(Cone, OpposedRowsAreImplicitEqualities) {
  const HalfspaceCone cone(Rows({{1, 0, 0}, {0, 1, 0}, {-2, 0, 0}}, 3));
  const ConeGenerators generators = Generators(cone);
  EXPECT_EQ(ImplicitEqualities(generators, 3), (std::vector<size_t>{0, 2}));
  EXPECT_EQ(Dimension(generators.cone), 2u);
  EXPECT_EQ(generators.lineality_dimension(), 1u);
}

TEST(Cone, CyclicConesMeetTheUpperBoundTheorem) {
  // Cones over cyclic polytopes of dimension 5: with m vertices on the moment curve they have
  // 2 C(m - 3, 2) facets [McMullen 1970].
  for (const int m : {6, 7, 8, 10, 12}) {
    IntegerMatrix rays(0, 6);
    for (int t = 1; t <= m; ++t) {
      IntegerVector row{1};
      for (int k = 1; k < 6; ++k) row.push_back(row.back() * Integer(t));
      rays.AppendRow(row);
    }
    const HalfspaceCone facets = Facets({IntegerMatrix(0, 6), rays});
    EXPECT_EQ(facets.inequalities.rows, static_cast<size_t>((m - 3) * (m - 4))) << m;
    EXPECT_EQ(facets.equalities.rows, 0u);
    EXPECT_EQ(Generators(facets).cone.rays.rows, static_cast<size_t>(m));
  }
}

TEST(Cone, ZeroRowsAreRefusedAndNamed) {
  const IntegerMatrix bad = Rows({{1, 0}, {0, 0}}, 2);
  const IntegerMatrix none(0, 2);
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const PreconditionError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_NE(message([&] { Generators(HalfspaceCone(bad)); }).find("inequality 1"), std::string::npos);
  EXPECT_NE(message([&] { Generators(HalfspaceCone(none, bad)); }).find("equality 1"), std::string::npos);
  EXPECT_NE(message([&] { Facets({bad, none}); }).find("line 1"), std::string::npos);
  EXPECT_NE(message([&] { Facets({none, bad}); }).find("ray 1"), std::string::npos);
  EXPECT_NE(message([&] {
              Generators({IntegerMatrix(0, 3), none});
            }).find("3 entries, got 2"),
            std::string::npos);
}

RC_GTEST_PROP(ConeBrute, RaysAreThoseOfAllSetsOfTightRows, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(8, 1, 5);
  const ConeGenerators generators = Generators(cone);
  RC_ASSERT(generators.cone.rays == BruteRays(cone));
  for (size_t k = 0; k < generators.tight.size(); ++k) {
    const IntegerVector values = Multiply(cone.inequalities, generators.cone.rays.row(k));
    for (size_t i = 0; i < values.size(); ++i)
      RC_ASSERT(generators.tight[k].Contains(i) == (values[i].sign() == 0));
  }
}

RC_GTEST_PROP(ConeLaw, LinesAreTheNullSpaceOfAllRows, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(12, 1, 7);
  IntegerMatrix all = cone.equalities;
  all.AppendRows(cone.inequalities);
  RC_ASSERT(Generators(cone).cone.lines == RowSpace(NullSpace(all)).vectors);
}

RC_GTEST_PROP(ConeLaw, DualOfTheDualIsTheCone, ()) {
  const GeneratorCone canonical = Generators(AnyHalfspaceCone(12, 1, 7)).cone;
  RC_ASSERT(Canonical(canonical) == canonical);
  const HalfspaceCone facets = Facets(canonical);
  RC_ASSERT(Facets(Generators(facets).cone) == facets);
  RC_ASSERT(facets.equalities.rows + Dimension(canonical) == canonical.ambient_dimension());
  RC_ASSERT(LinealityDimension(canonical) == canonical.lines.rows);
}

RC_GTEST_PROP(ConeLaw, GeneratorsDoNotDependOnTheOrderOrTheLengthOfRows, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(12, 1, 7);
  std::vector<IntegerVector> rows;
  for (size_t i = 0; i < cone.inequalities.rows; ++i) {
    const Integer length(Uniform(1, 5));
    rows.push_back(cone.inequalities.RowVector(i));
    for (Integer& entry : rows.back()) entry *= length;
  }
  std::sort(rows.begin(), rows.end());
  RC_ASSERT(Generators({Rows(rows, cone.ambient_dimension()), cone.equalities}).cone ==
            Generators(cone).cone);
}

RC_GTEST_PROP(ConeLaw, RedundantGeneratorsChangeNothing, ()) {
  const GeneratorCone cone = AnyGeneratorCone(7, 2, 6);
  GeneratorCone more = cone;
  for (size_t i = 0; i + 1 < cone.rays.rows; ++i) {
    IntegerVector sum = cone.rays.RowVector(i);
    for (size_t j = 0; j < sum.size(); ++j) sum[j] += Integer(2) * cone.rays(i + 1, j);
    if (std::any_of(sum.begin(), sum.end(), [](const Integer& e) { return e.sign() != 0; }))
      more.rays.AppendRow(sum);
  }
  RC_ASSERT(Facets(more) == Facets(cone));
}

RC_GTEST_PROP(ConeLaw, ImplicitEqualitiesVanishOnTheSumOfTheRaysAndNoOtherRowDoes, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(12, 1, 7);
  const ConeGenerators generators = Generators(cone);
  IntegerVector sum(cone.ambient_dimension());
  for (size_t k = 0; k < generators.cone.rays.rows; ++k) {
    for (size_t j = 0; j < sum.size(); ++j) sum[j] += generators.cone.rays(k, j);
  }
  std::vector<size_t> vanishing;
  const IntegerVector values = Multiply(cone.inequalities, sum);
  for (size_t i = 0; i < values.size(); ++i) {
    if (values[i].sign() == 0) vanishing.push_back(i);
  }
  RC_ASSERT(ImplicitEqualities(generators, cone.inequalities.rows) == vanishing);
}

}  // namespace
}  // namespace tact::algebra

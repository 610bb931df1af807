#include "algebra/exact/linear_algebra.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "algebra/error.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

using RationalRows = std::vector<std::vector<Rational>>;

// The obvious Gauss-Jordan elimination on fractions; returns the pivot columns.
std::vector<size_t> NaiveReduce(RationalRows& m, size_t columns) {
  std::vector<size_t> pivots;
  for (size_t column = 0; column < columns; ++column) {
    const size_t rank = pivots.size();
    size_t found = rank;
    while (found < m.size() && m[found][column].sign() == 0) ++found;
    if (found == m.size()) continue;
    std::swap(m[rank], m[found]);
    const Rational pivot = m[rank][column];
    for (Rational& entry : m[rank]) entry /= pivot;
    for (size_t i = 0; i < m.size(); ++i) {
      const Rational factor = m[i][column];
      if (i == rank || factor.sign() == 0) continue;
      for (size_t j = 0; j < m[i].size(); ++j) m[i][j] -= factor * m[rank][j];
    }
    pivots.push_back(column);
  }
  return pivots;
}

RationalRows ToRationals(const IntegerMatrix& a) {
  RationalRows rows(a.rows, std::vector<Rational>(a.columns));
  for (size_t i = 0; i < a.rows; ++i) {
    for (size_t j = 0; j < a.columns; ++j) rows[i][j] = Rational(a(i, j));
  }
  return rows;
}

// Small entries make ranks drop; a row is often a combination of two others; now and then everything is near
// 2^62.
IntegerMatrix AnyMatrix(size_t rows, size_t columns) {
  IntegerMatrix a(rows, columns);
  const bool huge = Uniform(0, 4) == 0;
  for (Integer& entry : a.entries) {
    const int small = Uniform(-2, 3);
    entry = huge ? Integer(small) * Integer((1LL << 62) - Uniform(0, 100)) : Integer(small);
  }
  for (size_t i = 2; i < rows; ++i) {
    if (Uniform(0, 3) != 0) continue;
    for (size_t j = 0; j < columns; ++j) a(i, j) = a(i - 1, j) + Integer(3) * a(i - 2, j);
  }
  return a;
}

IntegerMatrix AnyMatrix() { return AnyMatrix(Uniform<size_t>(0, 7), Uniform<size_t>(1, 8)); }

bool IsZero(const IntegerVector& v) {
  for (const Integer& entry : v) {
    if (entry.sign() != 0) return false;
  }
  return true;
}

TEST(LinearAlgebra, RankOfKnownMatrices) {
  EXPECT_EQ(Rank(IntegerMatrix::Identity(5)), 5u);
  EXPECT_EQ(Rank(IntegerMatrix(3, 4)), 0u);
  EXPECT_EQ(Rank(IntegerMatrix(0, 6)), 0u);
  EXPECT_EQ(Rank(IntegerMatrix::FromRows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, 3)), 2u);
  const std::vector<size_t> some = {0, 2};
  EXPECT_EQ(RankOfRows(IntegerMatrix::FromRows({{1, 2, 3}, {4, 5, 6}, {-2, -4, -6}}, 3), some), 1u);
}

TEST(LinearAlgebra, HilbertMatrixOfOrderTenIsInvertedThroughOverflow) {
  // The inverse's first entry is n^2, all entries are integers [Choi 1983].
  const size_t n = 10;
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n));
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) rows[i][j] = Rational(1, static_cast<int>(i + j + 1));
  }
  const Integer lcm(2LL * 2 * 2 * 2 * 3 * 3 * 5 * 7 * 11 * 13 * 17 * 19);
  IntegerMatrix scaled(n, n);
  std::vector<Rational> first(n);
  first[0] = Rational(lcm);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) scaled(i, j) = (Rational(lcm) * rows[i][j]).numerator();
  }
  const LinearSolution solution = Solve(scaled, first);
  ASSERT_TRUE(solution.x.has_value());
  EXPECT_EQ((*solution.x)[0], Rational(100));
  EXPECT_EQ((*solution.x)[1], Rational(-4950));
  for (const Rational& entry : *solution.x) EXPECT_TRUE(entry.is_integer());
}

TEST(LinearAlgebra, SmallestWordIsNoSpecialCase) {
  const Integer least = static_cast<long long>(std::numeric_limits<int64_t>::min());
  const IntegerMatrix a = IntegerMatrix::FromRows({{least, least}, {least, -least}}, 2);
  EXPECT_EQ(Rank(a), 2u);
  EXPECT_EQ(NullSpace(IntegerMatrix::FromRows({{least, Integer(1)}}, 2)),
            IntegerMatrix::FromRows({{Integer(1), -least}}, 2));
}

TEST(LinearAlgebra, ShapesThatDoNotMatchAreRefused) {
  const std::vector<Rational> three(3);
  EXPECT_THROW(Solve(IntegerMatrix::Identity(2), three), PreconditionError);
  EXPECT_THROW(IntegerMatrix::FromRows({{1, 2}, {3}}, 2), PreconditionError);
  const std::vector<size_t> none_such = {2};
  EXPECT_THROW(SelectColumns(IntegerMatrix::Identity(2), none_such), PreconditionError);
}

TEST(IntegerMatrix, RowsOfFractionsBecomePrimitive) {
  const std::vector<std::vector<Rational>> rows = {
      {Rational(1, 2), Rational(-1, 3)}, {0, 0}, {Rational(-4), Rational(6)}};
  EXPECT_EQ(IntegerMatrix::FromRationalRows(rows, 2), IntegerMatrix::FromRows({{3, -2}, {0, 0}, {-2, 3}}, 2));
}

RC_GTEST_PROP(LinearAlgebraTwin, RankAndRowSpaceEqualThoseOfNaiveGauss, ()) {
  const IntegerMatrix a = AnyMatrix();
  RationalRows naive = ToRationals(a);
  const std::vector<size_t> pivots = NaiveReduce(naive, a.columns);
  RC_ASSERT(Rank(a) == pivots.size());
  naive.resize(pivots.size());
  const EchelonBasis basis = RowSpace(a);
  RC_ASSERT(basis.pivots == pivots);
  RC_ASSERT(basis.vectors == IntegerMatrix::FromRationalRows(naive, a.columns));
}

RC_GTEST_PROP(LinearAlgebraLaw, RankOfTheTransposeIsTheSame, ()) {
  const IntegerMatrix a = AnyMatrix();
  RC_ASSERT(Rank(a) == Rank(Transpose(a)));
}

RC_GTEST_PROP(LinearAlgebraLaw, NullSpaceVanishesAndItsRankIsComplementary, ()) {
  const IntegerMatrix a = AnyMatrix();
  const IntegerMatrix basis = NullSpace(a);
  RC_ASSERT(basis.rows + Rank(a) == a.columns);
  RC_ASSERT(Rank(basis) == basis.rows);
  for (size_t i = 0; i < basis.rows; ++i) RC_ASSERT(IsZero(Multiply(a, basis.row(i))));
}

RC_GTEST_PROP(LinearAlgebraLaw, NullSpaceAndRowSpaceAreCanonical, ()) {
  const IntegerMatrix a = AnyMatrix();
  IntegerMatrix shuffled(0, a.columns);
  for (size_t i = a.rows; i-- > 0;) shuffled.AppendRow(a.row(i));
  for (size_t i = 0; i + 1 < a.rows; ++i) {
    for (size_t j = 0; j < a.columns; ++j) shuffled(i, j) += shuffled(i + 1, j) * Integer(-7);
  }
  RC_ASSERT(NullSpace(shuffled) == NullSpace(a));
  RC_ASSERT(RowSpace(shuffled).vectors == RowSpace(a).vectors);
}

RC_GTEST_PROP(LinearAlgebraLaw, VectorsThatDifferByTheSpaceReduceAlike, ()) {
  const IntegerMatrix a = AnyMatrix(3, 5);
  const IntegerMatrix v = AnyMatrix(1, 5);
  IntegerVector moved = v.RowVector(0);
  for (Integer& entry : moved) entry *= Integer(6);
  for (size_t i = 0; i < a.rows; ++i) {
    const Integer times(Uniform(-3, 4));
    for (size_t j = 0; j < 5; ++j) moved[j] += times * a(i, j);
  }
  const EchelonBasis basis = RowSpace(a);
  RC_ASSERT(ReduceModulo(basis, moved) == ReduceModulo(basis, v.row(0)));
}

RC_GTEST_PROP(LinearAlgebraTwin, SolveSolvesOrRefutes, ()) {
  const IntegerMatrix a = AnyMatrix();
  std::vector<Rational> b(a.rows);
  const bool surely_solvable = Uniform(0, 2) == 0;
  if (surely_solvable) {
    for (size_t j = 0; j < a.columns; ++j) {
      const Rational x(Uniform(-5, 6), Uniform(1, 4));
      for (size_t i = 0; i < a.rows; ++i) b[i] += Rational(a(i, j)) * x;
    }
  } else {
    for (Rational& entry : b) entry = Rational(Uniform(-5, 6), Uniform(1, 4));
  }
  const LinearSolution solution = Solve(a, b);
  RC_ASSERT(solution.x.has_value() == solution.refutation.empty());
  if (solution.x) {
    for (size_t i = 0; i < a.rows; ++i) {
      Rational sum;
      for (size_t j = 0; j < a.columns; ++j) sum += Rational(a(i, j)) * (*solution.x)[j];
      RC_ASSERT(sum == b[i]);
    }
  } else {
    RC_ASSERT(!surely_solvable);
    RC_ASSERT(IsZero(Multiply(Transpose(a), solution.refutation)));
    Rational sum;
    for (size_t i = 0; i < a.rows; ++i) sum += Rational(solution.refutation[i]) * b[i];
    RC_ASSERT(sum.sign() != 0);
  }
}

}  // namespace
}  // namespace tact::algebra

#include "provers/check/exact_rank.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/check/brute.h"

namespace tact::check {
namespace {

Matrix ToExact(const brute::Rows& rows, const mpz_class& scale = 1) {
  Matrix matrix;
  for (const brute::Row& row : rows) {
    Row exact;
    for (long long entry : row) exact.push_back(mpz_class(static_cast<long>(entry)) * scale);
    matrix.push_back(exact);
  }
  return matrix;
}

TEST(ExactRank, NoRowsHaveRankZeroAndZeroRowsToo) {
  EXPECT_EQ(Rank({}), 0);
  EXPECT_EQ(Rank({{0, 0, 0}, {0, 0, 0}}), 0);
}

TEST(ExactRank, OneUnitFarBelowDoublePrecisionDecides) {
  const mpz_class big("1000000000000000000000000000000000000000000000000000000000000", 10);
  EXPECT_EQ(Rank({{big, big + 1}, {big - 1, big}}), 2);  // big^2 - (big^2 - 1) = 1
  EXPECT_EQ(Rank({{big, big + 1}, {big * big, big * (big + 1)}}), 1);
}

RC_GTEST_PROP(ExactRankLaw, EqualsTheSizeOfTheLargestNonZeroMinor, ()) {
  const int height = *rc::gen::inRange(0, 7);
  brute::Rows rows;
  for (int i = 0; i < height; ++i) {
    brute::Row row;
    for (int j = 0; j < 6; ++j) row.push_back(*rc::gen::inRange(-1, 2));
    if (i >= 2 && *rc::gen::arbitrary<bool>()) {  // make deficient matrices common
      for (int j = 0; j < 6; ++j) row[j] = rows[i - 1][j] - 2 * rows[i - 2][j];
    }
    rows.push_back(row);
  }
  const mpz_class scale("123456789012345678901234567890", 10);
  RC_ASSERT(Rank(ToExact(rows)) == brute::Rank(rows));
  RC_ASSERT(Rank(ToExact(rows, scale)) == brute::Rank(rows));
}

}  // namespace
}  // namespace tact::check

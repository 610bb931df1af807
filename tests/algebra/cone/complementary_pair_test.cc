#include "algebra/cone/complementary_pair.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <string>

#include "algebra/error.h"

namespace tact::algebra {
namespace {

std::string Refusal(const std::vector<Integer>& rows, int columns) {
  try {
    FindComplementaryPair(rows, columns);
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return "taken";
}

TEST(ComplementaryPair, RowsThatAreNoneAreRefused) {
  for (const int columns : {-1, 0, 4, 7}) {
    EXPECT_EQ(Refusal({1, 0, 1}, columns), "a complementary pair needs rows of 1 to 6 columns") << columns;
  }
  EXPECT_NE(Refusal({1, 0, 0, 0}, 2).find("row 1"), std::string::npos);
}

// By hand: y = (1, 1, 0) holds x = 0, and the third row alone can be positive.
TEST(ComplementaryPair, OpposedRowsAreHeldAndTheOtherIsFree) {
  const ComplementaryPair pair = FindComplementaryPair({1, 0, -1, 0, 0, 1}, 2);
  EXPECT_EQ(pair.y[0], pair.y[1]);
  EXPECT_EQ(pair.y[0].sign(), 1);
  EXPECT_EQ(pair.y[2].sign(), 0);
  EXPECT_EQ(pair.x[0].sign(), 0);
  EXPECT_EQ(pair.x[1].sign(), 1);
}

// The definition, checked with + * and comparison alone; entries that leave 64 bits in the first product as well.
RC_GTEST_PROP(ComplementaryPairLaw, EachRowIsPositiveOnExactlyOneSide, ()) {
  const int columns = *rc::gen::inRange(1, 7);
  const size_t count = *rc::gen::inRange<size_t>(0, 13);
  const int64_t bound = *rc::gen::element<int64_t>(1, 3, std::numeric_limits<int64_t>::max() / 2);
  std::vector<Integer> rows;
  for (size_t i = 0; i < count; ++i) {
    bool zero = true;
    for (int j = 0; j < columns; ++j) {
      const int64_t entry = *rc::gen::inRange<int64_t>(-bound, bound + 1);
      zero = zero && entry == 0;
      rows.emplace_back(entry);
    }
    RC_PRE(!zero);
  }
  const ComplementaryPair pair = FindComplementaryPair(rows, columns);
  RC_ASSERT(pair.x.size() == static_cast<size_t>(columns));
  RC_ASSERT(pair.y.size() == count);
  std::vector<Integer> combination(static_cast<size_t>(columns));
  for (size_t i = 0; i < count; ++i) {
    Integer value;
    for (size_t j = 0; j < combination.size(); ++j) {
      const Integer& entry = rows[i * combination.size() + j];
      value += entry * pair.x[j];
      combination[j] += entry * pair.y[i];
    }
    RC_ASSERT(value.sign() >= 0);
    RC_ASSERT(pair.y[i].sign() >= 0);
    RC_ASSERT((value.sign() > 0) != (pair.y[i].sign() > 0));
  }
  for (const Integer& entry : combination) RC_ASSERT(entry.sign() == 0);
}

}  // namespace
}  // namespace tact::algebra

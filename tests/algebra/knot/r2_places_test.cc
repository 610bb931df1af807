#include "algebra/knot/r2_places.h"

#include <gtest/gtest.h>

#include "algebra/knot/columns.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// Twin: every place of b whose columns are mates of each other, whether it may be one or not.
TEST(R2Places, EachPlaceIsAnsweredAsByAComparison) {
  std::mt19937_64 random(4);
  long long equal = 0, different = 0;
  const auto compare = [&](const PData& a, const PData& b) {
    const R2Places places(a, b);
    for (int i = 1; i <= a.segments(); ++i) {
      for (int j = i; j <= a.segments(); ++j) {
        const int first = std::min(b.sigma(i), b.sigma(i + 1)), second = std::max(b.sigma(i), b.sigma(i + 1));
        if (first != j + 2 || second != j + 3) continue;
        const bool is_equal = EqualBut(a, {i, 2, j, 2}, b);
        ASSERT_EQ(places.EqualAt(i, j), is_equal) << a.ToJson() << b.ToJson() << i << " " << j;
        ++(is_equal ? equal : different);
      }
    }
  };
  for (int trial = 0; trial < 400; ++trial) {
    const PData a = RandomPData(random, trial % 10);
    for (const Move& move : AllMoves(a)) {
      if (move.kind != MoveKind::kR2 || move.direction != MoveDirection::kAdd || random() % 4 != 0) continue;
      const PData b = Apply(a, move);
      compare(a, b);
      // Another P-data with the place for an R2, seldom a's.
      const auto more = AllMoves(a);
      const PData other = Apply(a, more[random() % more.size()]);
      if (other.columns() == a.columns()) compare(other, b);
    }
  }
  for (const PData& b : PlanarPData(3)) {
    for (const PData& a : PlanarPData(1)) compare(a, b);
  }
  EXPECT_GT(equal, 1000);
  EXPECT_GT(different, 1000);
}

}  // namespace
}  // namespace tact::knot

#include "algebra/knot/column_match.h"

#include <gtest/gtest.h>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// Twin: every place asked in random order must be answered as by a comparison from scratch.
TEST(ColumnMatch, ACarriedVerdictIsThatOfAComparison) {
  std::mt19937_64 random(3);
  long long equal = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const PData a = RandomPData(random, 1 + trial % 9);
    const auto moves = AllMoves(a);
    const PData b = Apply(a, moves[random() % moves.size()]);
    const int more = b.columns() - a.columns();
    if (more != 2 && more != 4) continue;
    ColumnMatch match(a, b);
    for (int k = 0; k < 60; ++k) {
      const auto place = [&] { return 1 + static_cast<int>(random() % static_cast<unsigned>(a.segments())); };
      Renumbering to{place(), 2};
      if (more == 4) {
        to.second = place();
        to.second_count = 2;
        if (to.second < to.first) std::swap(to.first, to.second);
      }
      ASSERT_EQ(match.EqualAt(to), EqualBut(a, to, b)) << a.ToJson() << b.ToJson();
      equal += EqualBut(a, to, b) ? 1 : 0;
    }
  }
  EXPECT_GT(equal, 100);
}

// By hand: n kinks in a row and one more can have got it at any of the n + 1 segments between them, or at an end by a Cross.
TEST(ColumnMatch, EveryKinkOfARowMayBeTheNewOne) {
  const auto row = [](int kinks) {
    PDataBuilder p(2 * kinks);
    for (int k = 0; k < kinks; ++k) {
      p.Add(2 * k + 2, 3);
      p.Add(2 * k + 1, 4);
    }
    return p.Take();
  };
  const auto moves = DetectMoves(row(500), row(501));
  ASSERT_EQ(moves.size(), 503u);
  for (int k = 0; k <= 500; ++k) {
    EXPECT_EQ(moves[static_cast<size_t>(k)].kind, MoveKind::kR1);
    EXPECT_EQ(moves[static_cast<size_t>(k)].segments[0], 2 * k + 1);
  }
}

}  // namespace
}  // namespace tact::knot

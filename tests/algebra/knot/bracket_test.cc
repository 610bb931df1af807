#include "algebra/knot/bracket.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// The Jones polynomial of the trefoil, t + t^3 - t^4 with t = A^-4, for the positive one [Jones 1985].
TEST(Bracket, OfTheOverhandKnotIsTheTrefoils) {
  const PData overhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});
  EXPECT_EQ(NormalizedBracket(overhand), (BracketPolynomial{{-4, 1}, {-12, 1}, {-16, -1}}));
  EXPECT_EQ(NormalizedBracket(MirrorHeights(overhand)), (BracketPolynomial{{4, 1}, {12, 1}, {16, -1}}));
}

TEST(Bracket, OfTheStraightRopeAndOfALoopIsOne) {
  EXPECT_EQ(NormalizedBracket(PData()), OneBracket());
  for (const PData& p : PlanarPData(1)) EXPECT_EQ(NormalizedBracket(p), OneBracket());
}

TEST(Bracket, ReidemeisterMovesKeepIt) {
  std::mt19937_64 random(21);
  for (int trial = 0; trial < 60; ++trial) {
    const PData p = RandomPData(random, trial % 6);
    const BracketPolynomial bracket = NormalizedBracket(p);
    for (const Move& move : AllMoves(p)) {
      if (move.kind != MoveKind::kCross) {
        ASSERT_EQ(NormalizedBracket(Apply(p, move)), bracket) << p.ToJson();
      }
    }
  }
}

TEST(Bracket, ReadFromTheOtherEndItIsTheSame) {
  std::mt19937_64 random(22);
  for (int trial = 0; trial < 60; ++trial) {
    const PData p = RandomPData(random, trial % 8);
    ASSERT_EQ(NormalizedBracket(EquivalentPData(p)), NormalizedBracket(p));
  }
}

}  // namespace
}  // namespace tact::knot

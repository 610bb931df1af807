#include "algebra/knot/thesis_rules.h"

#include <gtest/gtest.h>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot::thesis {
namespace {

using Segments = std::vector<std::pair<int, int>>;

// By hand: a loop thrown in the straight rope, over itself or under.
TEST(ThesisRules, AKinkOfTheStraightRopeIsR1AtItsOnlySegmentAndACrossOfBothEnds) {
  const PData kink({2, 1}, {3, 4});
  EXPECT_EQ(RemoveR1(kink, 1), PData());
  EXPECT_EQ(FindR1(PData(), kink), std::vector<int>{1});
  EXPECT_EQ(FindCrossAtSelectiveEnd(PData(), kink), 1);
  EXPECT_EQ(FindCrossAtOtherEnd(PData(), kink), 1);
}

// By hand: the rope folded back over itself, i = j.
TEST(ThesisRules, TheRuleForR2DoesNotSeeASegmentLaidOverItself) {
  const PData folded({3, 4, 1, 2}, {1, 3, 2, 4});
  EXPECT_EQ(FindR2(PData(), folded), Segments{});
  EXPECT_EQ(FindR2(PData(), folded, {true, true, true}), (Segments{{1, 1}}));
}

// [thesis, Figure 5.11]: two strands woven, here with the least number of intersections.
TEST(ThesisRules, OneTransitionMayBeR2OfThreePairsOfSegments) {
  const PData before({4, 5, 6, 1, 2, 3}, {1, 3, 4, 2, 4, 3});
  const PData after({6, 7, 8, 9, 10, 1, 2, 3, 4, 5}, {1, 3, 1, 3, 4, 2, 4, 2, 4, 3});
  EXPECT_EQ(FindR2(before, after), (Segments{{1, 4}, {2, 5}, {3, 6}}));
}

TEST(ThesisRules, TheRuleForR3LeavesOutSegmentN) {
  const PData before({3, 6, 1, 5, 4, 2}, {1, 2, 2, 2, 1, 1});
  const PData after({5, 4, 6, 2, 1, 3}, {2, 1, 2, 2, 1, 1});
  EXPECT_TRUE(FindR3(before, after).empty());
  const auto found = FindR3(before, after, {R3Triangle::kFaces, true, true});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].segments, (std::array<int, 3>{6, 2, 4}));
}

// The types as the thesis lists them, on columns i-1, i = 1, 2; j-1, j = 3, 4; k-1, k = 5, 6.
TEST(ThesisRules, TheEightTypesAreThoseOfTheList) {
  const std::pair<char, std::vector<int>> types[] = {{'A', {3, 5, 1, 6, 2, 4}}, {'B', {3, 6, 1, 5, 4, 2}},
                                                     {'C', {4, 5, 6, 1, 2, 3}}, {'D', {4, 6, 5, 1, 3, 2}},
                                                     {'E', {5, 3, 2, 6, 1, 4}}, {'F', {6, 3, 2, 5, 4, 1}},
                                                     {'G', {5, 4, 6, 2, 1, 3}}, {'H', {6, 4, 5, 2, 3, 1}}};
  for (const auto& [type, sigma] : types) {
    std::vector<int> attr;
    for (int i = 1; i <= 6; ++i) attr.push_back(sigma[static_cast<size_t>(i) - 1] > i ? 1 : 2);
    EXPECT_EQ(TypeOf(PData(sigma, attr), {2, 4, 6}), type);
  }
  EXPECT_EQ(TypeOf(PData({2, 1, 5, 6, 3, 4}, {1, 2, 1, 1, 2, 2}), {2, 4, 6}), std::nullopt);
}

TEST(ThesisRules, RemovalsAreThoseOfTheMovesTheyName) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const PData p = RandomPData(random, 2 + trial % 7);
    const auto moves = AllMoves(p);
    for (int k = 0; k < 20; ++k) {
      const Move& move = moves[random() % moves.size()];
      if (move.direction != MoveDirection::kAdd) continue;
      const PData q = Apply(p, move);
      const auto [i, j, unused] = move.segments;
      const bool selective = move.end == RopeEnd::kSelective;
      EXPECT_EQ(move.kind == MoveKind::kR1   ? RemoveR1(q, i)
                : move.kind == MoveKind::kR2 ? RemoveR2(q, i, j)
                : selective                  ? RemoveCrossAtSelectiveEnd(q)
                                             : RemoveCrossAtOtherEnd(q),
                p);
    }
  }
}

}  // namespace
}  // namespace tact::knot::thesis

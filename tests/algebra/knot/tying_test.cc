#include "algebra/knot/tying.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "algebra/error.h"
#include "algebra/knot/tying_bound.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

using Distances = std::map<PData, int>;

// Every P-data within so many steps of the start, on the way never more than so many intersections, by trying every move.
Distances Around(const PData& start, const MoveRules& rules, int steps, int most_crossings) {
  Distances distance = {{start, 0}};
  std::vector<PData> layer = {start};
  for (int step = 1; step <= steps; ++step) {
    std::vector<PData> next;
    for (const PData& p : layer) {
      for (const Move& move : AllMoves(p, most_crossings)) {
        if (!rules.Allow(move)) continue;
        const PData q = Apply(p, move);
        if (distance.emplace(q, step).second) next.push_back(q);
      }
    }
    layer = std::move(next);
  }
  return distance;
}

void ExpectSequence(const PData& knot, const MoveRules& rules, const Tying& tying) {
  PData p;
  for (const TyingStep& step : tying.steps) {
    ASSERT_TRUE(rules.Allow(step.move));
    ASSERT_FALSE(FindMoveFault(p, step.move)) << *FindMoveFault(p, step.move);
    p = Apply(p, step.move);
    ASSERT_EQ(p, step.reached);
  }
  ASSERT_EQ(p, knot);
}

// A way of at most three steps between P-data of at most three intersections never has more than four.
void ExpectTwin(const MoveRules& rules) {
  const Distances distance = Around(PData(), rules, 3, 4);
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : PlanarPData(n)) {
      TyingOptions options;
      options.rules = rules;
      options.limit = 3;
      const Tying tying = TieShortest(p, options);
      const auto found = distance.find(p);
      ASSERT_EQ(tying.found, found != distance.end()) << p.ToJson() << tying.impossible;
      if (!tying.found) continue;
      ASSERT_EQ(static_cast<int>(tying.steps.size()), found->second) << p.ToJson();
      ASSERT_TRUE(tying.proved_shortest());
      ExpectSequence(p, rules, tying);
    }
  }
}

TEST(Tying, LengthsAreTheDistancesOfTheWholeMoveGraph) { ExpectTwin({}); }
TEST(Tying, LengthsAreTheDistancesWithoutR1) { ExpectTwin({.r1 = false}); }
TEST(Tying, LengthsAreTheDistancesWithoutR2) { ExpectTwin({.r2 = false}); }
TEST(Tying, LengthsAreTheDistancesWithoutR3) { ExpectTwin({.r3 = false}); }
TEST(Tying, LengthsAreTheDistancesWithoutCross) { ExpectTwin({.cross = false}); }
TEST(Tying, LengthsAreTheDistancesWithAnEndHeld) {
  ExpectTwin({.held = RopeEnd::kSelective});
  ExpectTwin({.held = RopeEnd::kOther});
}
TEST(Tying, LengthsAreTheDistancesOfReidemeisterTwoAndThree) { ExpectTwin({.r1 = false, .cross = false}); }

// Four intersections: three steps or fewer just if the ball of two steps round the straight rope meets the knot's neighbours.
TEST(Tying, FourIntersectionsTakeThreeStepsJustIfTwoBallsMeet) {
  const Distances near = Around(PData(), {}, 2, 6);
  std::mt19937_64 random(11);
  int shorter = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const PData p = RandomPData(random, 4);
    int least = 4;
    if (near.count(p) == 1) least = near.at(p);
    for (const auto& [q, steps] : Around(p, {}, 1, 6)) {
      const auto met = near.find(q);
      if (met != near.end()) least = std::min(least, met->second + steps);
    }
    const Tying tying = TieShortest(p);
    ASSERT_EQ(static_cast<int>(tying.steps.size()), least) << p.ToJson();
    ASSERT_TRUE(tying.proved_shortest());
    ExpectSequence(p, {}, tying);
    shorter += least < 4 ? 1 : 0;
  }
  EXPECT_GT(shorter, 0);
}

TEST(Tying, TheBoundChangesByAtMostOneAndDetourSaysHow) {
  std::mt19937_64 random(3);
  for (const MoveRules& rules : {MoveRules{}, MoveRules{.r2 = false}, MoveRules{.cross = false}}) {
    for (int trial = 0; trial < 300; ++trial) {
      const PData p = RandomPData(random, trial % 9);
      const TyingBound bound(p, rules);
      for (const Move& move : AllMoves(p)) {
        if (!rules.Allow(move)) continue;
        const TyingBound after(Apply(p, move), rules);
        ASSERT_EQ(after.steps() - bound.steps(), bound.Detour(move) - 1) << p.ToJson();
        ASSERT_LE(std::abs(after.steps() - bound.steps()), 1);
      }
    }
  }
}

TEST(Tying, TheStraightRopeNeedsNoStepWhateverIsAllowed) {
  const Tying tying = TieShortest(PData(), {.rules = {false, false, false, false}});
  EXPECT_TRUE(tying.found && tying.steps.empty() && tying.proved_shortest());
}

// Three intersections of one sign, two of them met first above: the bound is three, and three Cross moves do it.
TEST(Tying, TheOverhandKnotTakesThreeSteps) {
  const Tying tying = TieShortest(kOverhand);
  EXPECT_EQ(tying.steps.size(), 3u);
  EXPECT_TRUE(tying.proved_shortest());
}

TEST(Tying, AKnottedRopeIsRefusedToReidemeisterMovesWithAReason) {
  const Tying tying = TieShortest(kOverhand, {.rules = {.cross = false}});
  EXPECT_FALSE(tying.found);
  EXPECT_NE(tying.impossible.find("bracket"), std::string::npos);
  EXPECT_NE(TieShortest(kOverhand, {.rules = {.r1 = false, .cross = false}}).impossible.find("R1 and Cross"),
            std::string::npos);
}

TEST(Tying, TheLimitExcludesWhatIsLonger) {
  const Tying tying = TieShortest(kOverhand, {.limit = 2});
  EXPECT_FALSE(tying.found);
  EXPECT_TRUE(tying.impossible.empty());
  EXPECT_EQ(tying.excluded_below, 3);
}

TEST(Tying, TheBudgetLeavesASequenceAndSaysWhatIsExcluded) {
  std::mt19937_64 random(8);
  TyingOptions small;
  small.most_states = 30;
  int open = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const PData p = RandomPData(random, 9);
    const Tying tying = TieShortest(p, small), whole = TieShortest(p);
    ASSERT_TRUE(tying.found && whole.found);
    ExpectSequence(p, {}, tying);
    ASSERT_LE(tying.excluded_below, static_cast<int>(whole.steps.size()));
    ASSERT_LE(whole.steps.size(), tying.steps.size());
    open += tying.proved_shortest() ? 0 : 1;
  }
  EXPECT_GT(open, 0);
}

TEST(Tying, TooSmallABudgetWithNothingFoundIsUndecided) {
  // What one R2 makes of the straight rope: the bracket is 1, and R1 alone has nowhere to begin.
  const PData lens({3, 4, 1, 2}, {1, 3, 2, 4});
  EXPECT_THROW(TieShortest(lens, {.rules = {true, false, false, false}, .most_states = 1000}), BudgetError);
}

TEST(Tying, WhatNoSphereHoldsIsRefused) {
  EXPECT_THROW(TieShortest(PData({3, 4, 1, 2}, {3, 3, 4, 4})), PreconditionError);
}

}  // namespace
}  // namespace tact::knot

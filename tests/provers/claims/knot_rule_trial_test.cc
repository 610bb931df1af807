#include "provers/claims/knot_rule_trial.h"

#include <gtest/gtest.h>

#include "provers/claims/knot_r3_trial.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveKind;
using knot::PData;

// Straight ropes have one segment: a kink of four attributes. By hand, the least is (2 1; 1 2).
TEST(KnotRuleTrial, ARuleThatFindsNothingMissesEveryMoveAndTheLeastIsKept) {
  RuleTrial trial;
  TryMoves(trial, MoveKind::kR1, Effort::kQuick,
           [](const PData&, const Move&, const PData&) { return false; });
  EXPECT_GT(trial.moves, 0);
  EXPECT_EQ(trial.missed, trial.moves);
  EXPECT_EQ(trial.random_missed, trial.random_moves);
  EXPECT_GT(trial.random_moves, 0);
  EXPECT_FALSE(trial.complete());
  EXPECT_EQ(trial.least_missed.before, PData());
  EXPECT_EQ(trial.least_missed.after, PData({2, 1}, {1, 2}));
}

TEST(KnotRuleTrial, OneThatFindsAllIsComplete) {
  RuleTrial trial;
  const auto leads = [](const PData& p, const Move& move, const PData& q) {
    return move.kind == MoveKind::kR2 && Realises(p, move, q) && q.crossings() == p.crossings() + 2;
  };
  TryMoves(trial, MoveKind::kR2, Effort::kQuick, leads);
  EXPECT_TRUE(trial.complete());
  EXPECT_FALSE(RuleTrial().complete());
}

TEST(KnotRuleTrial, ConclusionsAboutRandomRopesCountButAreNoLeastPairs) {
  RuleTrial trial;
  TryConclusions(trial, Effort::kQuick, [&](const PData& after) {
    ++trial.conclusions;
    if (after.crossings() < 6) return;
    ++trial.wrong;
    trial.least_wrong.Offer(PData(), after, {1});
  });
  EXPECT_GT(trial.wrong, 0);
  EXPECT_GT(trial.conclusions, trial.wrong);
  EXPECT_FALSE(trial.sound());
  EXPECT_FALSE(trial.least_wrong.found);
}

TEST(KnotRuleTrial, PlacesOfR3VariantsAreThoseNamed) {
  EXPECT_EQ(R3Variants()[kR3Corrected].file, "corrected");
  EXPECT_EQ(R3Variants()[kR3SignsOnly].file, "signs-only");
  EXPECT_EQ(R3TrialsTo(Effort::kQuick).size(), R3Variants().size());
  EXPECT_EQ(&R3TrialsTo(Effort::kQuick), &R3TrialsTo(Effort::kQuick));
}

}  // namespace
}  // namespace tact::provers

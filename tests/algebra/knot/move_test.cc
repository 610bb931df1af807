#include "algebra/knot/move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "algebra/error.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

TEST(Moves, EveryMoveStaysOnTheSphereAndIsUndone) {
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : PlanarPData(n)) {
      for (const Move& move : AllMoves(p, 4)) {
        ASSERT_FALSE(FindMoveFault(p, move));
        const PData q = Apply(p, move);
        ASSERT_FALSE(PData::FindFault(q.SigmaRow(), q.AttrRow()));
        ASSERT_TRUE(IsPlanar(q)) << p.ToJson() << " " << q.ToJson();
        ASSERT_EQ(Apply(q, Inverse(move)), p);
      }
    }
  }
}

TEST(Moves, DetectionFindsExactlyTheMovesThatLeadThere) {
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : PlanarPData(n)) {
      std::map<PData, std::vector<Move>> reached;
      for (const Move& move : AllMoves(p)) reached[Apply(p, move)].push_back(move);
      for (const auto& [q, moves] : reached) {
        ASSERT_EQ(DetectMoves(p, q), moves) << p.ToJson() << " " << q.ToJson();
      }
    }
  }
}

TEST(Moves, NothingIsDetectedWhereNoMoveLeads) {
  std::vector<PData> world;
  for (int n = 0; n <= 2; ++n) {
    for (const PData& p : PlanarPData(n)) world.push_back(p);
  }
  for (const PData& p : world) {
    std::set<PData> reached;
    for (const Move& move : AllMoves(p)) reached.insert(Apply(p, move));
    for (const PData& q : world) ASSERT_EQ(!DetectMoves(p, q).empty(), reached.count(q) == 1);
  }
}

TEST(Moves, AMoveAndItsInverseAreBothGenerated) {
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : PlanarPData(n)) {
      for (const Move& move : AllMoves(p, 4)) {
        const auto back = AllMoves(Apply(p, move));
        ASSERT_TRUE(std::binary_search(back.begin(), back.end(), Inverse(move)));
      }
    }
  }
}

TEST(Moves, TheEquivalentMoveDoesTheSameToTheRope) {
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : PlanarPData(n)) {
      for (const Move& move : AllMoves(p, 4)) {
        const PData q = Apply(p, move);
        const Move other = EquivalentMove(move.direction == MoveDirection::kRemove ? q : p, move);
        ASSERT_EQ(Apply(EquivalentPData(p), other), EquivalentPData(q)) << p.ToJson();
      }
    }
  }
}

// From the straight rope, by hand: four R1; for each end both sides of the one segment, over and under; R2 of the segment
// with itself: one side with itself (2 sides), or both sides through the only face (2 orders), each over or under.
TEST(Moves, OfTheStraightRopeAreKnownByHand) {
  std::map<MoveKind, int> count;
  for (const Move& move : AllMoves(PData())) ++count[move.kind];
  EXPECT_EQ(count[MoveKind::kR1], 4);
  EXPECT_EQ(count[MoveKind::kCross], 8);
  EXPECT_EQ(count[MoveKind::kR2], 8);
  EXPECT_EQ(count[MoveKind::kR3], 0);
}

TEST(Moves, TheOverhandKnotHasNoReidemeisterMoveThatRemoves) {
  for (const Move& move : AllMoves(kOverhand)) {
    if (move.direction == MoveDirection::kAdd) continue;
    EXPECT_EQ(move.kind, MoveKind::kCross);
  }
}

TEST(Moves, R3IsItsOwnInverseAndKeepsItsSegments) {
  int found = 0;
  for (const PData& p : PlanarPData(3)) {
    for (const Move& move : AllMoves(p, 3)) {
      if (move.kind != MoveKind::kR3) continue;
      ++found;
      const PData q = Apply(p, move);
      EXPECT_NE(q, p);
      EXPECT_EQ(Apply(q, move), p);
      EXPECT_EQ(DetectMoves(p, q), std::vector<Move>{move});
    }
  }
  EXPECT_GT(found, 0);
}

TEST(Moves, AMoveThatIsNotAdmittedIsRefusedWithAReason) {
  const Move r2{MoveKind::kR2, MoveDirection::kRemove, {1, 2, 0}, RopeEnd::kNone, 1, false};
  EXPECT_EQ(FindMoveFault(PData(), r2), "expected 2 intersections to remove, got 0");
  EXPECT_THROW(Apply(PData(), r2), PreconditionError);
  const Move r1{MoveKind::kR1, MoveDirection::kAdd, {9, 0, 0}, RopeEnd::kNone, 1, false};
  EXPECT_EQ(FindMoveFault(kOverhand, r1), "expected a segment from 1 to 7, got 9");
  const Move cross{MoveKind::kCross, MoveDirection::kAdd, {1, 0, 0}, RopeEnd::kNone, 1, false};
  EXPECT_EQ(FindMoveFault(kOverhand, cross), "expected the end that crosses, got none");
}

TEST(Moves, RandomRopesAreExplainedByTheMoveThatWasMade) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const PData p = RandomPData(random, 4 + trial % 12);
    const auto moves = AllMoves(p);
    for (int k = 0; k < 20; ++k) {
      const Move& move = moves[random() % moves.size()];
      const PData q = Apply(p, move);
      ASSERT_TRUE(IsPlanar(q));
      const auto found = DetectMoves(p, q);
      ASSERT_TRUE(std::find(found.begin(), found.end(), move) != found.end()) << p.ToJson() << q.ToJson();
      for (const Move& other : found) ASSERT_EQ(Apply(p, other), q);
    }
  }
}

}  // namespace
}  // namespace tact::knot

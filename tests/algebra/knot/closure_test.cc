#include "algebra/knot/closure.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "algebra/knot/dt_code.h"
#include "algebra/knot/pd_code.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// The overhand knot of the thesis' Figure 5.16.
const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});

// Length of a shortest closing path by Bellman-Ford over segments.
int DistanceByRelaxation(const PData& p) {
  const Faces faces(p);
  std::vector<int> distance(static_cast<size_t>(faces.count()), 1 << 20);
  distance[static_cast<size_t>(faces.left_of({p.segments(), true}))] = 0;
  for (int round = 0; round < faces.count(); ++round) {
    for (int s = 1; s <= p.segments(); ++s) {
      int& left = distance[static_cast<size_t>(faces.left_of({s, true}))];
      int& right = distance[static_cast<size_t>(faces.left_of({s, false}))];
      left = std::min(left, right + 1);
      right = std::min(right, left + 1);
    }
  }
  return distance[static_cast<size_t>(faces.left_of({1, false}))];
}

// The arc is a sequence of Cross moves of the other end; applied one by one they must give the same.
PData CloseByMoves(const PData& p, bool over) {
  PData q = p;
  std::vector<int> crossed;
  for (const Dart d : ClosingPath(p)) {
    int segment = d.segment;
    for (const int other : crossed) segment += other < d.segment ? 1 : 0;
    crossed.push_back(d.segment);
    const int attr = AttributeOf(over, d.forward ? 1 : -1);
    q = Apply(q, {MoveKind::kCross, MoveDirection::kAdd, {segment, 0, 0}, RopeEnd::kOther, attr});
  }
  return q;
}

void ExpectClosed(const PData& p) {
  for (const Pass pass : {Pass::kOver, Pass::kUnder}) {
    const PData closed = CloseBy(p, pass);
    ASSERT_EQ(PData::FindFault(closed.SigmaRow(), closed.AttrRow()), std::nullopt) << p.ToJson();
    ASSERT_TRUE(IsPlanar(closed) && EndsOnOneFace(closed)) << p.ToJson();
    ASSERT_EQ(closed.crossings(), p.crossings() + DistanceByRelaxation(p)) << p.ToJson();
    for (int i = closed.columns(); closed.crossings() - p.crossings() > closed.columns() - i; --i)
      ASSERT_EQ(closed.over(i), pass == Pass::kOver);
    ASSERT_EQ(closed, CloseByMoves(p, pass == Pass::kOver)) << p.ToJson();
    for (const int even : DtCodeOf({closed})) ASSERT_EQ(even % 2, 0);
  }
}

TEST(Closure, OverhandKnotIsATrefoilAndItsEndsMeet) {
  EXPECT_TRUE(EndsOnOneFace(kOverhand));
  EXPECT_TRUE(ClosingPath(kOverhand).empty());
  const ClosedCode closed = Close(kOverhand, Pass::kOver);
  EXPECT_EQ(closed.cut, kOverhand);
  // KnotInfo, 3_1: DT notation [4, 6, 2]; its Gauss notation {-1, 2, -3, 1, -2, 3} starts on a lower strand.
  EXPECT_EQ(DtText(DtCodeOf(closed)), "4 6 2");
  EXPECT_EQ(closed.Gauss().passes, (std::vector<int>{1, -2, 3, -1, 2, -3}));
  EXPECT_EQ(ToText(ClosedPdCodeOf(closed.cut)), "PD[X[4,2,5,1],X[2,6,3,5],X[6,4,1,3]]");
}

TEST(Closure, OrientedGaussSaysHowTheOtherStrandPasses) {
  // All signs +: the lower strand passes the upper one from right to left, the upper the lower from left to right.
  EXPECT_EQ(Close(kOverhand, Pass::kOver).OrientedGauss(), "+<1 ->2 +<3 ->1 +<2 ->3");
}

TEST(Closure, EveryPlanarPDataToThreeCrossingsCloses) {
  for (int c = 0; c <= 3; ++c) {
    for (const PData& p : PlanarPData(c)) ExpectClosed(p);
  }
}

TEST(Closure, RandomRopesToFortyCrossingsClose) {
  std::mt19937_64 random(7);
  for (int crossings = 4; crossings <= 40; ++crossings) ExpectClosed(RandomPData(random, crossings));
}

TEST(Closure, JoiningEndsOnTwoFacesIsRefused) {
  for (const PData& p : PlanarPData(2)) {
    if (EndsOnOneFace(p)) {
      EXPECT_EQ(JoinEnds(p).cut, Close(p, Pass::kUnder).cut);
    } else {
      EXPECT_THROW(JoinEnds(p), PreconditionError);
    }
  }
}

}  // namespace
}  // namespace tact::knot

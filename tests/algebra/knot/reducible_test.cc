#include "algebra/knot/reducible.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algebra/error.h"
#include "algebra/knot/closure.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

bool SidesAreOneFace(const PData& p, int segment) {
  const Faces faces(p);
  return faces.left_of({segment, true}) == faces.left_of({segment, false});
}

// Definition 6 word for word: all i, j, k.
std::vector<ColumnInterval> IntervalsByDefinition(const PData& p) {
  std::vector<ColumnInterval> intervals;
  for (int i = 1; i <= p.columns(); ++i) {
    for (int j = i + 1; j <= p.columns(); ++j) {
      if (i == 1 && j == p.columns()) continue;
      bool all = true;
      for (int k = i; k <= j; ++k) all = all && i <= p.sigma(k) && p.sigma(k) <= j;
      if (all) intervals.push_back({i, j});
    }
  }
  return intervals;
}

TEST(Reducible, ThesisExamplesAreIrreducible) {
  EXPECT_TRUE(IsIrreducible(PData({4, 5, 6, 1, 2, 3}, {3, 1, 2, 4, 2, 1})));
  EXPECT_TRUE(IsIrreducible(PData()));
  EXPECT_TRUE(IsIrreducible(PData({2, 1}, {1, 2})));
  EXPECT_FALSE(IsIrreducible(PData({2, 1, 4, 3}, {1, 2, 1, 2})));
  EXPECT_EQ(ClosedIntervals(PData({4, 3, 2, 1}, {1, 1, 2, 2})), (std::vector<ColumnInterval>{{2, 3}}));
}

TEST(Reducible, AgreesWithDefinitionSixOnEveryPDataToFourCrossings) {
  for (int c = 0; c <= 4; ++c) {
    ForEachPData(c, [&](const PData& p) {
      for (int i = 1; i <= p.columns(); ++i) {
        if (p.sigma(i) > i && p.attr(i) != 1) return;  // attributes play no part
      }
      const auto intervals = IntervalsByDefinition(p);
      ASSERT_EQ(ClosedIntervals(p), intervals) << p.ToJson();
      ASSERT_EQ(IsIrreducible(p), intervals.empty()) << p.ToJson();
    });
  }
}

TEST(Reducible, SplitAndJoinAreInverseOnEveryPDataToFourCrossings) {
  for (int c = 0; c <= 4; ++c) {
    ForEachPData(c, [&](const PData& p) {
      const auto parts = Split(p);
      ASSERT_EQ(Join(parts), p) << p.ToJson();
      ASSERT_EQ(IsIrreducible(p), parts.size() <= 1) << p.ToJson();
      for (const Part& part : parts) {
        ASSERT_EQ(PData::FindFault(part.p.SigmaRow(), part.p.AttrRow()), std::nullopt);
        ASSERT_TRUE(IsIrreducible(part.p));
      }
    });
  }
}

// The law that reducible.h states: a handle comes just where the ends of what is inserted and the sides of the segment
// are on two faces each.
TEST(Reducible, GenusOfAnInsertionIsTheSumButForOneCase) {
  std::vector<PData> all;
  for (int c = 0; c <= 2; ++c) ForEachPData(c, [&](const PData& p) { all.push_back(p); });
  for (const PData& y : all) {
    for (const PData& x : all) {
      for (int segment = 1; segment <= y.segments(); ++segment) {
        const bool handle = !SidesAreOneFace(y, segment) && !EndsOnOneFace(x);
        ASSERT_EQ(Genus(Insert(y, segment, x)), Genus(y) + Genus(x) + (handle ? 1 : 0))
            << y.ToJson() << x.ToJson() << segment;
      }
    }
  }
}

// Thesis, 5.1.3: all P-data follow from irreducible ones "by appropriately connecting". Planar parts do not suffice.
TEST(Reducible, PlanarPartsDoNotMakePlanarPData) {
  std::set<int> refuted;
  for (int c = 0; c <= 3; ++c) {
    ForEachPData(c, [&](const PData& p) {
      bool planar_parts = true;
      for (const Part& part : Split(p)) planar_parts = planar_parts && IsPlanar(part.p);
      if (IsPlanar(p)) {
        ASSERT_TRUE(planar_parts);
      } else if (planar_parts) {
        refuted.insert(c);
      }
    });
  }
  EXPECT_EQ(refuted, std::set<int>{3});
  const PData kink({2, 1}, {1, 2}), curl({3, 4, 1, 2}, {1, 2, 2, 1});
  EXPECT_TRUE(IsPlanar(kink) && IsPlanar(curl));
  EXPECT_EQ(Genus(Insert(kink, 2, curl)), 1);
  EXPECT_EQ(Genus(Insert(kink, 1, curl)), 0);
}

// Each part's shape may be mirrored by itself: whether both sides of a segment or both ends lie on one face stays.
TEST(Reducible, APlanarPairingOfKPartsHasTwoToTheKPlanarChoicesOfTurns) {
  for (int c = 1; c <= 4; ++c) {
    std::map<std::vector<int>, size_t> choices;
    ForEachPData(c, [&](const PData& p) {
      for (int i = 1; i <= p.columns(); ++i) {
        if (p.sigma(i) > i && !p.over(i)) return;
      }
      if (!IsPlanar(p)) return;
      ++choices[p.SigmaRow()];
      for (Part part : Split(p)) {
        auto mirrored = Split(p);
        for (Part& other : mirrored) other.p = other == part ? MirrorShape(other.p) : other.p;
        ASSERT_TRUE(IsPlanar(Join(mirrored))) << p.ToJson();
      }
    });
    for (const auto& [sigma, count] : choices) {
      std::vector<int> attr;
      for (size_t i = 0; i < sigma.size(); ++i) attr.push_back(sigma[i] > static_cast<int>(i) ? 1 : 2);
      EXPECT_EQ(count, size_t{1} << Split(PData(sigma, attr)).size());
    }
  }
}

TEST(Reducible, RandomRopesToFortyCrossingsSplitAndJoin) {
  std::mt19937_64 random(5);
  for (int crossings = 5; crossings <= 40; ++crossings) {
    const PData p = RandomPData(random, crossings);
    EXPECT_EQ(Join(Split(p)), p) << p.ToJson();
    for (const Part& part : Split(p)) EXPECT_TRUE(IsPlanar(part.p));
  }
}

TEST(Reducible, ASegmentThatIsNotThereIsRefused) {
  EXPECT_THROW(Insert(PData({2, 1}, {1, 2}), 4, PData()), PreconditionError);
  EXPECT_THROW(Insert(PData(), 0, PData()), PreconditionError);
}

}  // namespace
}  // namespace tact::knot

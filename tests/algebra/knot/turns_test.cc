#include "algebra/knot/turns.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "algebra/knot/reducible.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// Every pair of interlaced intersections follows the law.
void ExpectLaw(const PData& p) {
  for (int i = 1; i <= p.columns(); ++i) {
    for (int a = i + 1; a < p.sigma(i); ++a) {
      if (p.sigma(a) < p.sigma(i)) continue;
      EXPECT_EQ(TurnsAgree(p, i, a), p.turn(i) == p.turn(a)) << p.ToJson() << i << " " << a;
    }
  }
}

TEST(Turns, OfEveryPlanarPDataToFourIntersectionsFollowTheLaw) {
  for (int c = 0; c <= 4; ++c) {
    for (const PData& p : PlanarPData(c)) ExpectLaw(p);
  }
}

// Brute: of all choices of turns, whether one is planar.
TEST(Turns, AreFoundJustWhereSomeAreThere) {
  for (int c = 0; c <= 4; ++c) {
    std::set<std::vector<int>> planar;
    for (const PData& p : PlanarPData(c)) planar.insert(p.SigmaRow());
    ForEachPData(c, [&](const PData& p) {
      const auto turned = WithPlanarTurns(p);
      ASSERT_EQ(turned.has_value(), planar.contains(p.SigmaRow())) << p.ToJson();
      if (!turned) return;
      EXPECT_TRUE(IsPlanar(*turned));
      EXPECT_EQ(turned->SigmaRow(), p.SigmaRow());
      for (int i = 1; i <= c; ++i) EXPECT_EQ(turned->over(i), p.over(i));
      if (c > 0) {
        EXPECT_EQ(turned->turn(1), 1);
      }
    });
  }
}

TEST(Turns, OfRandomRopesToFortyIntersectionsFollowTheLawAndAreFound) {
  std::mt19937_64 random(9);
  for (int crossings = 5; crossings <= 40; ++crossings) {
    const PData p = RandomPData(random, crossings);
    ExpectLaw(p);
    for (const Part& part : Split(p)) {
      const PData expected = part.p.turn(1) > 0 ? part.p : [&] {
        PDataBuilder mirrored(part.p.columns());
        for (int i = 1; i <= part.p.columns(); ++i)
          mirrored.Add(part.p.sigma(i), AttributeOf(part.p.over(i), -part.p.turn(i)));
        return mirrored.Take();
      }();
      EXPECT_EQ(WithPlanarTurns(part.p), expected) << part.p.ToJson();
    }
  }
}

// Each part's turns are open, and nothing else: mirrored parts stay of a sphere, a single other turn does not.
RC_GTEST_PROP(Turns, OneTurnChangedInAPartOfSeveralIntersectionsLeavesTheSphere, (uint64_t seed)) {
  std::mt19937_64 random(seed);
  const PData p = RandomIrreduciblePData(random, *rc::gen::inRange(14, 40));
  RC_PRE(p.crossings() > 1);
  const int changed = 1 + static_cast<int>(random() % static_cast<uint64_t>(p.columns()));
  PDataBuilder other(p.columns());
  for (int i = 1; i <= p.columns(); ++i) {
    const bool turned = i == changed || p.sigma(i) == changed;
    other.Add(p.sigma(i), AttributeOf(p.over(i), turned ? -p.turn(i) : p.turn(i)));
  }
  RC_ASSERT(!IsPlanar(other.Take()));
}

}  // namespace
}  // namespace tact::knot

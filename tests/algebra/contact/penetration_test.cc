#include <gtest/gtest.h>

#include "tests/algebra/contact/touching_solids.h"

namespace tact::algebra {
namespace {

FoundContacts Find(const PolygonSoup& moving, const PolygonSoup& fixed, const Rational& tolerance = 0) {
  return FindContacts(BuildPolyhedron(moving), BuildPolyhedron(fixed), tolerance);
}

TEST(Penetration, VertexInsideHasItsDepth) {
  const FoundContacts deep = Find(Box({-2, -2, -2}, {2, 2, 2}), Box({1, 1, 1}, {9, 9, 9}));
  ASSERT_TRUE(deep.penetration);
  EXPECT_EQ(deep.penetration->squared_depth, Rational(1));
  EXPECT_TRUE(deep.relation.contacts.empty());
  EXPECT_FALSE(Find(Box({-2, -2, -2}, {2, 2, 2}), Box({1, 1, 1}, {9, 9, 9}), 1).penetration);
  EXPECT_TRUE(Find(Box({-2, -2, -2}, {2, 2, 2}), Box({1, 1, 1}, {9, 9, 9}), Rational(99, 100)).penetration);
}

TEST(Penetration, EdgesPierceWithoutAVertexInside) {
  const FoundContacts found =
      Find(Box({-5, -1, -1}, {5, 1, 1}), Box({Rational(-1, 2), -5, -3}, {Rational(1, 2), 5, 0}));
  ASSERT_TRUE(found.penetration);
  EXPECT_EQ(found.penetration->where.z, Rational(0));
  EXPECT_EQ(found.penetration->squared_depth, Rational(1));
}

// Every vertex and edge of each lies on the other's surface.
TEST(Penetration, CoincidentSolidsOverlapAtAnyTolerance) {
  const PolygonSoup cube = Box({0, 0, 0}, {2, 2, 2});
  EXPECT_FALSE(FindPenetration(BuildPolyhedron(cube), BuildPolyhedron(cube), 0));
  for (const Rational& tolerance : {Rational(0), Rational(1, 100), Rational(1, 2)}) {
    const FoundContacts found = Find(cube, cube, tolerance);
    ASSERT_TRUE(found.penetration) << tolerance.ToString();
    EXPECT_EQ(found.penetration->where, (Vector3{1, 1, 1}));
    EXPECT_EQ(found.penetration->squared_depth, Rational(1));
  }
}

TEST(Penetration, BoxesFlushOnFourSidesOverlapAtAnyTolerance) {
  for (const Rational& tolerance : {Rational(0), Rational(1, 100)}) {
    const FoundContacts found = Find(Box({0, 0, 0}, {2, 2, 2}), Box({0, 0, 1}, {2, 2, 3}), tolerance);
    ASSERT_TRUE(found.penetration) << tolerance.ToString();
    EXPECT_EQ(found.penetration->squared_depth, Rational(1, 4));
  }
}

// Against the definition (MeetingOf) and against points of a grid, some deep inside both.
TEST(PenetrationTwin, AgreesWithHalfSpacesAndSampledPoints) {
  int overlapping = 0, apart = 0;
  for (unsigned seed = 80000; seed < 80250; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const SampleBody fixed = RandomBody(dice);
    const Pose X{RandomRotation(dice), Rational(1, 2) * dice.RollVector(-4, 4)};
    const SampleBody moving = Transform(RandomBody(dice), X);
    const auto penetration = FindContacts(moving.solid, fixed.solid, 0).penetration;
    ASSERT_EQ(penetration.has_value(), MeetingOf(moving, fixed) == Meeting::kOverlapping);
    if (penetration && penetration->squared_depth.sign() > 0) {
      ++overlapping;
      const Side a = Locate(moving.solid, penetration->where), b = Locate(fixed.solid, penetration->where);
      ASSERT_TRUE(a != Side::kOutside && b != Side::kOutside);
      ASSERT_TRUE(a == Side::kInside || b == Side::kInside);
    }
    if (penetration) continue;
    ++apart;
    for (int i = 0; i < 20; ++i) {
      const Vector3 p = Rational(1, 4) * dice.RollVector(-12, 12);
      ASSERT_FALSE(Locate(moving.solid, p) == Side::kInside && Locate(fixed.solid, p) == Side::kInside);
    }
  }
  EXPECT_GT(overlapping, 60);
  EXPECT_GT(apart, 40);
}

}  // namespace
}  // namespace tact::algebra

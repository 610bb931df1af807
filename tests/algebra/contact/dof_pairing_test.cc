#include "algebra/contact/dof_pairing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace tact::algebra {
namespace {

using enum DofIndex;

Contact At(int x, int y, int z, Vector3 normal) { return {{x, y, z}, {std::move(normal)}, ""}; }

const ContactRelation kFree;
const ContactRelation kFloor = {{At(0, 0, 0, {0, 0, 1})}};
const ContactRelation kFloorAndWall = {{At(0, 0, 0, {0, 0, 1}), At(0, 0, 0, {1, 0, 0})}};
const ContactRelation kFloorAndCeiling = {{At(0, 0, 0, {0, 0, 1}), At(1, 0, 0, {0, 0, -1})}};
const ContactRelation kEdgeOnEdge = {{{{0, 0, 0}, {{0, 0, 1}, {1, 0, 0}}, ""}}};

int Directions(const DofPairing& pairing, DofIndex from, DofIndex to) {
  return pairing[static_cast<size_t>(from)][static_cast<size_t>(to)];
}

// Hand-made: what each direction of x, y, z is before and after.
TEST(PairByDirection, FloorThenWall) {
  const DofPairing p = PairByDirection(kFloor, kFloorAndWall, Motion::kTranslation);
  EXPECT_EQ(Directions(p, kMaintaining, kMaintaining), 1);  // y
  EXPECT_EQ(Directions(p, kMaintaining, kDetaching), 1);    // x
  EXPECT_EQ(Directions(p, kDetaching, kDetaching), 1);      // z
}

TEST(PairByDirection, FloorThenCeiling) {
  const DofPairing p = PairByDirection(kFloor, kFloorAndCeiling, Motion::kTranslation);
  EXPECT_EQ(Directions(p, kMaintaining, kMaintaining), 2);
  EXPECT_EQ(Directions(p, kDetaching, kConstraining), 1);
  EXPECT_EQ(Directions(p, kMaintaining, kConstraining), 0);
}

TEST(PairByDirection, CountsAreAmbiguousWhereDirectionsAreNot) {
  // From a wall to a floor and a ceiling: by counts 2 1 0 -> 2 0 1 is detaching -> constraining; by direction the
  // wall's x becomes free and the free z blocked.
  const ContactRelation wall = {{At(0, 0, 0, {1, 0, 0})}};
  const DofPairing p = PairByDirection(wall, kFloorAndCeiling, Motion::kTranslation);
  EXPECT_EQ(Directions(p, kDetaching, kMaintaining), 1);
  EXPECT_EQ(Directions(p, kMaintaining, kConstraining), 1);
}

TEST(PairByDirection, SlideOffTheRim) {
  const DofPairing p = PairByDirection(kFloor, kEdgeOnEdge, Motion::kTranslation);
  EXPECT_EQ(Directions(p, kMaintaining, kSingularMaintaining), 2);
  EXPECT_EQ(Directions(p, kDetaching, kSingularMaintaining), 1);
}

RC_GTEST_PROP(PairByDirection, RowsAndColumnsAreTheDofs, ()) {
  const auto relation = [] {
    ContactRelation r;
    const auto coordinate = [] { return Rational(*rc::gen::inRange(-2, 3)); };
    const int size = *rc::gen::inRange(0, 6);
    while (static_cast<int>(r.contacts.size()) < size) {
      Contact c{{coordinate(), coordinate(), coordinate()}, {}, ""};
      const int planes = *rc::gen::inRange(0, 4) == 0 ? 2 : 1;
      while (static_cast<int>(c.planes.size()) < planes) {
        const Vector3 n{coordinate(), coordinate(), coordinate()};
        if (!n.IsZero()) c.planes.push_back(n);
      }
      r.contacts.push_back(c);
    }
    return r;
  };
  const ContactRelation before = relation(), after = relation();
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    const DofPairing p = PairByDirection(before, after, motion),
                     back = PairByDirection(after, before, motion);
    std::array<int, kDofIndices> rows{}, columns{};
    for (int i = 0; i < kDofIndices; ++i) {
      for (int j = 0; j < kDofIndices; ++j) {
        RC_ASSERT(p[i][j] >= 0);
        RC_ASSERT(p[i][j] == back[j][i]);
        rows[i] += p[i][j];
        columns[j] += p[i][j];
      }
    }
    RC_ASSERT(rows == Indices(ComputeMotionDof(before), motion));
    RC_ASSERT(columns == Indices(ComputeMotionDof(after), motion));
  }
}

RC_GTEST_PROP(ForcedDofTransitions, AreThoseOfEveryPairing, ()) {
  // Twin: all ways to send what falls to what rises, one unit after the other.
  const auto dof = [] {
    MotionDof d;
    d.singular = *rc::gen::inRange(0, 2) == 1;
    d.translation.maintaining = *rc::gen::inRange(0, 4);
    d.translation.detaching = *rc::gen::inRange(0, 4 - d.translation.maintaining);
    d.translation.constraining = 3 - d.translation.maintaining - d.translation.detaching;
    return d;
  };
  const MotionDof before = dof(), after = dof();
  const auto a = Indices(before, Motion::kTranslation), b = Indices(after, Motion::kTranslation);
  std::vector<int> falls, rises;
  for (int i = 0; i < kDofIndices; ++i) {
    for (int k = b[i]; k < a[i]; ++k) falls.push_back(i);
    for (int k = a[i]; k < b[i]; ++k) rises.push_back(i);
  }
  std::set<std::pair<int, int>> always;
  bool first = true;
  do {
    std::set<std::pair<int, int>> pairs;
    for (size_t i = 0; i < falls.size(); ++i) pairs.insert({falls[i], rises[i]});
    std::set<std::pair<int, int>> both;
    std::set_intersection(always.begin(), always.end(), pairs.begin(), pairs.end(),
                          std::inserter(both, both.end()));
    always = first ? pairs : both;
    first = false;
  } while (std::next_permutation(rises.begin(), rises.end()));
  std::set<std::pair<int, int>> forced;
  for (const DofTransition& t : ForcedDofTransitions(before, after)) {
    if (t.motion == Motion::kTranslation) forced.insert({static_cast<int>(t.from), static_cast<int>(t.to)});
  }
  RC_ASSERT(forced == always);
}

TEST(AnalyzeTransition, DirectionsDecideWhereTheCountsLeaveAChoice) {
  const ContactRelation floor_and_rim = {{At(0, 0, 0, {0, 0, 1}), kEdgeOnEdge.contacts[0]}};
  EXPECT_TRUE(IsAmbiguous(ComputeMotionDof(floor_and_rim), ComputeMotionDof(kFloorAndWall)));
  const Transition t = AnalyzeTransition(floor_and_rim, kFloorAndWall);
  EXPECT_TRUE(t.ambiguous);
  // z: singular detaching -> detaching; x: singular maintaining -> detaching; y: -> maintaining.
  const std::vector<DofTransition> expected = {{Motion::kTranslation, kSingularMaintaining, kMaintaining},
                                               {Motion::kTranslation, kSingularMaintaining, kDetaching},
                                               {Motion::kTranslation, kSingularDetaching, kDetaching}};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), t.dof_transitions.begin()));
  EXPECT_EQ(std::count(t.sub_skills.begin(), t.sub_skills.end(), SubSkill::kDetachContactInTranslation), 0);
  const Transition by_counts =
      AnalyzeTransition(ComputeMotionDof(floor_and_rim), ComputeMotionDof(kFloorAndWall));
  EXPECT_EQ(std::count(by_counts.sub_skills.begin(), by_counts.sub_skills.end(),
                       SubSkill::kDetachContactInTranslation),
            1);
}

TEST(AnalyzeTransition, WithoutAChoiceTheCountsAreTaken) {
  EXPECT_EQ(AnalyzeTransition(kFloor, kFloorAndWall).dof_transitions,
            AnalyzeTransition(ComputeMotionDof(kFloor), ComputeMotionDof(kFloorAndWall)).dof_transitions);
  EXPECT_FALSE(AnalyzeTransition(kFree, kFloorAndCeiling).ambiguous);
}

}  // namespace
}  // namespace tact::algebra

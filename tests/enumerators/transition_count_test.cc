#include "enumerators/transition_count.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algebra/contact/dof_pairing.h"
#include "enumerators/lattice_solid.h"

namespace tact::enumerators {
namespace {

using algebra::DofIndex;
using algebra::Polyhedron;
using algebra::Rational;

constexpr int kM = 0, kD = 1, kC = 2, kSm = 3;

Polyhedron Box(int x, int y, int z) { return LatticeSolid({{{0, 0, 0}, {x, y, z}}}); }
Polyhedron Slot() { return LatticeSolid({{{0, 0, 0}, {3, 1, 2}}}, {{{1, 0, 1}, {2, 1, 2}}}); }

uint64_t Sum(const TransitionCount& count, Measure measure, bool opens, int motion, int from, int to) {
  uint64_t sum = 0;
  for (int lost = 0; lost <= 3; ++lost) sum += count.Count({measure, lost, opens, motion, from, to});
  return sum;
}

const std::vector<TransitionCount>& SmallUnits() {
  static const std::vector<TransitionCount> units = [] {
    std::vector<TransitionCount> counts;
    for (const SolidPair& pair : SolidPairs(FamilySize::kSmall)) {
      if (!pair.turns) counts.push_back(CountTransitions(pair, counts.size()));
    }
    return counts;
  }();
  return units;
}

// By hand (contact_formation_test.cc has the states): a cube comes from the free formation into one of 54 face contacts,
// one direction from maintaining to detaching; every other contact of a cube and a block is singular.
TEST(TransitionCount, CubeOnABlockCountedByHand) {
  const TransitionCount count = CountTransitions({"", "", Box(1, 1, 1), Box(2, 2, 2)}, 0);
  EXPECT_EQ(count.formations, 219U);
  EXPECT_EQ(count.borders, 866U);
  // Lost dimensions: 1 from free to the 54 faces, more for edges and corners of the configuration obstacle.
  EXPECT_EQ(count.Count({Measure::kTransitions, 1, false, 0, 0, 0}) +
                count.Count({Measure::kTransitions, 1, false, 0, 0, 1}) +
                count.Count({Measure::kTransitions, 1, false, 0, 1, 1}),
            54U + (count.borders - 218 - count.Count({Measure::kDimensions, 2, false, 0, 2, 0})));
  for (int motion = 0; motion < 2; ++motion) {
    for (int from = 0; from < algebra::kDofIndices; ++from) {
      for (int to = 0; to < algebra::kDofIndices; ++to) {
        const bool expected = (from == kM && (to == kD || to == kSm)) || (from == kD && to == kSm);
        EXPECT_EQ(Sum(count, Measure::kByDirection, false, motion, from, to) > 0, expected) << from << to;
      }
    }
  }
}

// From a singular relation a singular maintaining direction becomes constraining: critical. By hand: between the walls the peg
// is over the floor or on it, and its ends stick out of the slot on one side or the other, or are flush: six formations.
// Sticking out over the floor (two of dimension 2), it borders on these singular ones: the rims, ends alike or flush or at the
// slot's end; the slot's end, over the floor or on it. Two lose one dimension, three lose two. Flush over the floor, it borders
// on the flush rims; sticking out on the floor (two) on the slot's end: one dimension each.
TEST(TransitionCount, PegLeavesTheRimsForTheSlot) {
  const TransitionCount count = CountTransitions({"", "", Box(1, 1, 2), Slot()}, 0);
  EXPECT_EQ(count.Count({Measure::kByDirection, 1, true, 0, kSm, kC}), 2U * 2 + 1 + 2);
  EXPECT_EQ(count.Count({Measure::kByDirection, 2, true, 0, kSm, kC}), 2U * 3);
  EXPECT_EQ(Sum(count, Measure::kCritical, true, 0, 0, 0),
            Sum(count, Measure::kByDirection, true, 0, kSm, kC));
  EXPECT_EQ(Sum(count, Measure::kCritical, false, 0, 0, 0), 0U);
}

TEST(TransitionCount, OneWayBackIsTheOther) {
  for (const TransitionCount& count : SmallUnits()) {
    for (const Measure measure : {Measure::kByDirection, Measure::kForced, Measure::kAllPairs}) {
      for (int motion = 0; motion < 2; ++motion) {
        for (int from = 0; from < algebra::kDofIndices; ++from) {
          for (int to = 0; to < algebra::kDofIndices; ++to) {
            for (int lost = 1; lost <= 3; ++lost)
              EXPECT_EQ(count.Count({measure, lost, false, motion, from, to}),
                        count.Count({measure, lost, true, motion, to, from}));
          }
        }
      }
    }
  }
}

// What the counts force happens by direction: whichever way one pairs them, it is there.
TEST(TransitionCount, ForcedKindsGoByDirection) {
  for (const TransitionCount& count : SmallUnits()) {
    for (const auto& [key, tally] : count.tallies) {
      if (key.measure != Measure::kForced) continue;
      TallyKey by_direction = key;
      by_direction.measure = Measure::kByDirection;
      EXPECT_GE(count.Count(by_direction), tally.count);
    }
  }
}

TEST(TransitionCount, LawsHoldOfTranslations) {
  TransitionCount total;
  for (const TransitionCount& count : SmallUnits()) Merge(&total, count);
  for (int law = 0; law < static_cast<int>(TransitionLaws().size()); ++law) {
    EXPECT_GT(
        Sum(total, Measure::kLawTried, false, 0, law, 0) + Sum(total, Measure::kLawTried, true, 0, law, 0),
        0U);
    EXPECT_EQ(
        Sum(total, Measure::kLawBroken, false, 0, law, 0) + Sum(total, Measure::kLawBroken, true, 0, law, 0),
        0U)
        << TransitionLaws()[static_cast<size_t>(law)].statement;
  }
}

TEST(TransitionCount, UnitsMergeInAnyOrder) {
  TransitionCount forwards, backwards;
  for (const TransitionCount& count : SmallUnits()) Merge(&forwards, count);
  for (auto count = SmallUnits().rbegin(); count != SmallUnits().rend(); ++count) Merge(&backwards, *count);
  EXPECT_EQ(forwards, backwards);
}

// Every first place is where it says: the relations there have such a transition.
TEST(TransitionCount, FirstPlacesShowTheirKind) {
  const SolidPair pair{"", "", Box(1, 1, 2), Slot()};
  for (const auto& [key, tally] : CountTransitions(pair, 0).tallies) {
    if (key.measure != Measure::kAllPairs) continue;
    const PlacePoses poses = PosesOf(tally.first);
    const auto dof = [&](const algebra::Pose& pose) {
      return ComputeMotionDof(FindContacts(Transform(pair.moving, pose), pair.fixed, 0).relation);
    };
    const auto before =
        Indices(dof(key.opens ? poses.border : poses.open), static_cast<algebra::Motion>(key.motion));
    const auto after =
        Indices(dof(key.opens ? poses.open : poses.border), static_cast<algebra::Motion>(key.motion));
    EXPECT_GT(before[static_cast<size_t>(key.from)], after[static_cast<size_t>(key.from)]);
    EXPECT_LT(before[static_cast<size_t>(key.to)], after[static_cast<size_t>(key.to)]);
  }
}

}  // namespace
}  // namespace tact::enumerators

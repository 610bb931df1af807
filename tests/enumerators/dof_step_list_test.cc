#include "enumerators/dof_step_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "algebra/contact/motion_dof.h"
#include "enumerators/translation_steps.h"

namespace tact::enumerators {
namespace {

using enum AdditionKind;

// Twin: the pairs that one contact makes, by the walk over all normals with entries -1, 0, 1.
KindSteps InTranslation(const DofStepList& list) {
  KindSteps steps;
  for (const FoundStep& s : list.found)
    steps.insert({{s.from[0], s.from[1], s.from[2]}, {s.to[0], s.to[1], s.to[2]}});
  return steps;
}

TEST(DofStepList, AgreesWithTheStepsInTranslation) {
  const KindSteps possible = TranslationSteps(3).front().steps;
  const auto lists = ListDofSteps(DofStepCensus(CornerWorld(3)).Count());
  for (const DofStepList& list : lists) {
    if (list.definition != &DofDefinitions().front()) continue;
    const KindSteps found = InTranslation(list);
    EXPECT_FALSE(found.empty());
    EXPECT_TRUE(std::ranges::includes(possible, found)) << ToString(list.kind);
  }
}

TEST(FullDofStepList, TheCornerWorldHasAllSixteenInTranslation) {
  const auto lists = ListDofSteps(DofStepCensus(CornerWorld(5)).Count());
  EXPECT_EQ(InTranslation(lists.front()), TranslationSteps(4).front().steps);
}

TEST(DofStepList, EveryDefinitionHasEveryStepOnce) {
  const DofSteps steps = DofStepCensus(CornerWorld(3)).Count();
  std::map<AdditionKind, uint64_t> all;
  for (const DofStep& step : steps) all[step.kind] += step.count;
  const auto lists = ListDofSteps(steps);
  ASSERT_EQ(lists.size(), 33U);
  for (const DofStepList& list : lists) EXPECT_EQ(list.steps(), all[list.kind]);
}

TEST(DofStepList, AFinerDefinitionTellsMorePairsApart) {
  const auto lists = ListDofSteps(DofStepCensus(CornerWorld(3)).Count());
  for (size_t kind = 0; kind < kAdditionKinds; ++kind) {
    const auto pairs = [&](size_t definition) { return lists[11 * kind + definition].found.size(); };
    EXPECT_LE(pairs(0), pairs(4));   // translation; and rotation
    EXPECT_LE(pairs(4), pairs(5));   // and types
    EXPECT_LE(pairs(5), pairs(10));  // and all motion
  }
  EXPECT_GE(CountPairs(lists, 10), lists[10].found.size());
  EXPECT_LE(CountPairs(lists, 10), lists[10].found.size() + lists[21].found.size() + lists[32].found.size());
}

TEST(DofStepList, CountsOfAPair) {
  const auto lists = ListDofSteps(DofStepCensus(CornerWorld(2)).Count());
  EXPECT_EQ(lists.front().Count({3, 0, 0}, {2, 1, 0}), 28U);
  EXPECT_EQ(lists.front().Count({2, 1, 0}, {3, 0, 0}), 0U);
}

// By hand: a contact against which an edge comes from the other side blocks the turn about the edge's square, which
// was free: rotation (3, 0, 0) becomes (2, 0, 1).
TEST(DirectBlocks, TheSmallestIsAContactAgainstAnEdge) {
  const DofStepCensus census(CornerWorld(3));
  const auto blocks = CountDirectBlocks(census.Count());
  ASSERT_EQ(blocks.size(), 6U);
  for (const DirectBlocks& block : blocks) {
    const bool some = block.kind != kContact && block.motion == algebra::Motion::kRotation;
    EXPECT_EQ(block.steps > 0, some) << ToString(block.kind);
    EXPECT_EQ(block.smallest.has_value(), some);
  }
  const StepWitness& edge = *blocks[3].smallest;
  EXPECT_EQ(edge.relation.size(), 1U);
  const algebra::RotationDof before = ComputeMotionDof(census.Relation(edge.relation)).rotation;
  std::vector<size_t> all = edge.relation;
  all.insert(all.end(), edge.added.begin(), edge.added.end());
  const algebra::RotationDof after = ComputeMotionDof(census.Relation(all)).rotation;
  EXPECT_EQ((std::array{before.maintaining, before.detaching, before.constraining}), (std::array{3, 0, 0}));
  EXPECT_EQ((std::array{after.maintaining, after.detaching, after.constraining}), (std::array{2, 0, 1}));
}

}  // namespace
}  // namespace tact::enumerators

#include "enumerators/dof_class_list.h"

#include <gtest/gtest.h>

#include "algebra/error.h"

namespace tact::enumerators {
namespace {

TEST(DofClassList, EveryDefinitionHasEveryRelationOnceAndTheFirstWitnessOfItsClass) {
  const DofCensus census(CubeWorld(3));
  const DofCounts counts = census.Count();
  const auto lists = ListDofClasses(counts);
  ASSERT_EQ(lists.size(), DofDefinitions().size());
  for (const DofClassList& list : lists) {
    uint64_t relations = 0;
    for (const FoundClass& found : list.found) {
      relations += found.count;
      for (const DofCount& c : counts) {
        if (IndexValues(c.dof, *list.definition) != found.values) continue;
        EXPECT_FALSE(ComesBefore(c.witness, found.witness));
      }
    }
    EXPECT_EQ(relations, census.relations());
    EXPECT_FALSE(list.complete()) << list.definition->name;
  }
}

// docs/dof-classes.md has the bounds, counted by hand.
TEST(DofClassList, BoundsAreThoseOfTheLemmas) {
  std::vector<size_t> bounds;
  for (const DofClassList& list : ListDofClasses({})) {
    EXPECT_TRUE(list.found.empty());
    bounds.push_back(list.upper_bound);
  }
  EXPECT_EQ(bounds, (std::vector<size_t>{10, 10, 20, 28, 66, 90, 95, 66, 110, 107, 142}));
}

TEST(DofClassList, ATupleThatALemmaExcludesIsABug) {
  algebra::MotionDof impossible = DofClasses().front();
  for (const algebra::MotionDof& candidate : DofCandidates()) {
    if (ExcludingLemma(candidate)) impossible = candidate;
  }
  EXPECT_THROW(ListDofClasses({{impossible, 1, {}}}), InvariantError);
}

TEST(DofClassList, BoxWorldsHaveNormalsAlongAxesOnly) {
  EXPECT_TRUE(IsBoxWorld(CubeWorld(1)));
  EXPECT_TRUE(IsBoxWorld(AxisWorld(1)));
  EXPECT_FALSE(IsBoxWorld(CornerWorld(1)));
  EXPECT_FALSE(IsBoxWorld(DiagonalWorld(1)));
}

}  // namespace
}  // namespace tact::enumerators

#include "enumerators/dof_class.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "algebra/error.h"
#include "enumerators/dof_census.h"

namespace tact::enumerators {
namespace {

size_t DistinctClasses(const std::string& definition) {
  for (const DofDefinition& d : DofDefinitions()) {
    if (d.name == definition) return CountDistinct(DofClasses(), d);
  }
  throw std::logic_error("no definition " + definition);
}

std::vector<algebra::MotionDof> Dofs(const DofCounts& counts) {
  std::vector<algebra::MotionDof> dofs;
  for (const DofCount& c : counts) dofs.push_back(c.dof);
  return dofs;
}

// Ten is the number of ways to write 3 as an ordered sum of three, and what the thesis names for translation.
TEST(DofClasses, TenInTranslation) { EXPECT_EQ(DistinctClasses("translation"), 10U); }

// The upper bounds were also counted by hand from the lemmas (docs/dof-classes.md has the sums).
TEST(DofClasses, CountsByHand) {
  EXPECT_EQ(DistinctClasses("translation, rotation"), 66U);
  EXPECT_EQ(DistinctClasses("translation, rotation with types"), 90U);
  EXPECT_EQ(DistinctClasses("translation, rotation, all motion"), 107U);
  EXPECT_EQ(DofClasses().size(), 142U);
}

TEST(DofClasses, EveryClassHasAWitnessWithTheFewestContacts) {
  const DofCensus census(CornerWorld(7));
  const DofCounts counts = census.Count();
  EXPECT_EQ(Dofs(counts), DofClasses());
  for (const DofCount& c : counts) EXPECT_EQ(c.witness.size(), FewestContacts(c.dof));
}

TEST(DofClasses, BoxesHave139AndWithoutTheEmptyRelation138) {
  const DofCounts counts = DofCensus(CubeWorld(9)).Count();
  EXPECT_EQ(counts.size(), 139U);
  EXPECT_EQ(Dofs(counts), BoxClasses());
  EXPECT_EQ(std::count_if(counts.begin(), counts.end(), [](const DofCount& c) { return !c.witness.empty(); }),
            138);
}

TEST(DofLemmas, EachExcludesACandidateThatNoOtherExcludes) {
  const auto candidates = DofCandidates();
  for (const DofLemma& lemma : DofLemmas()) {
    const bool needed = std::any_of(candidates.begin(), candidates.end(), [&](const algebra::MotionDof& dof) {
      return !lemma.holds(dof) &&
             std::all_of(DofLemmas().begin(), DofLemmas().end(),
                         [&](const DofLemma& other) { return other.id == lemma.id || other.holds(dof); });
    });
    EXPECT_TRUE(needed) << lemma.id;
  }
}

TEST(DofLemmas, HoldForDiagonalNormals) {
  for (const DofCount& c : DofCensus(DiagonalWorld(2)).Count())
    EXPECT_FALSE(ExcludingLemma(c.dof)) << c.count;
}

TEST(DofIndices, UnknownNameIsRefused) {
  EXPECT_THROW(algebra::IndexValue(DofClasses().front(), "rotation.wobbling"), PreconditionError);
}

TEST(DofCensus, UnitsAddUpInAnyOrder) {
  const DofCensus census(CornerWorld(6));
  ASSERT_GT(census.units(), 1U);
  DofCounts backwards;
  uint64_t relations = 0;
  for (size_t unit = census.units(); unit-- > 0;) DofCensus::Merge(backwards, census.CountUnit(unit));
  for (const DofCount& c : backwards) relations += c.count;
  EXPECT_EQ(relations, census.relations());
  EXPECT_EQ(backwards, census.Count());
}

TEST(DofCensus, AgreesWithTheWalkOfSets) {
  // Twin: the engine on each relation of the world's own walk, sets without repetition kept.
  const ContactWorld world = CubeWorld(4);
  const DofCensus census(world);
  std::map<algebra::MotionDof, uint64_t> twin;
  ForEachRelation(world, [&](const algebra::ContactRelation& relation) {
    for (size_t i = 1; i < relation.contacts.size(); ++i) {
      if (relation.contacts[i] == relation.contacts[i - 1]) return;
    }
    ++twin[algebra::ComputeMotionDof(relation)];
  });
  const DofCounts counts = census.Count();
  ASSERT_EQ(counts.size(), twin.size());
  for (const DofCount& c : counts) {
    EXPECT_EQ(c.count, twin[c.dof]);
    EXPECT_EQ(algebra::ComputeMotionDof(census.Relation(c.witness)), c.dof);
  }
}

TEST(DofCensus, RefusesWhatItCannotCount) {
  EXPECT_THROW(DofCensus(SingularWorld(2)), PreconditionError);
  EXPECT_THROW(DofCensus(CubeWorld(2)).CountUnit(99), PreconditionError);
  EXPECT_THROW(NamedWorld("flat", 2), PreconditionError);
}

}  // namespace
}  // namespace tact::enumerators

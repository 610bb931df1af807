#include "provers/claims/census.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "provers/check/check.h"
#include "provers/claims/definitions.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::MotionDof;
using enumerators::AxisWorld;
using enumerators::SingularWorld;

// What a refuted outcome shows: its certificate's relation, which the checker accepts.
nlohmann::json Counterexample(const Outcome& outcome) {
  EXPECT_EQ(outcome.verdict, Verdict::kRefuted);
  if (outcome.certificates.size() != 1) return nullptr;
  const check::Answer answer = check::CheckCertificate(outcome.certificates[0].json);
  EXPECT_TRUE(answer.accepted) << answer.why;
  return nlohmann::json::parse(outcome.certificates[0].json)["relation"]["contacts"];
}

TEST(Census, TheClassesHaveAllMembersOfTheWorldBetweenThem) {
  for (const auto& world : {AxisWorld(0), AxisWorld(2), SingularWorld(2), enumerators::DiagonalWorld(1)}) {
    const Census census = TakeCensus(world);
    EXPECT_EQ(census.count, Count(world));
    // Brute: every relation on its own, its class looked up.
    std::map<MotionDof, std::pair<size_t, ContactRelation>> classes;
    ForEachRelation(world, [&](const ContactRelation& relation) {
      auto& [count, first] = classes[algebra::ComputeMotionDof(relation)];
      if (count++ == 0) first = relation;
    });
    ASSERT_EQ(census.classes.size(), classes.size());
    size_t sum = 0;
    auto expected = classes.begin();
    for (const CensusClass& c : census.classes) {
      EXPECT_EQ(c.dof, expected->first) << "by increasing DOFs";
      EXPECT_EQ(c.count, expected->second.first);
      EXPECT_EQ(c.witness, expected->second.second) << "the first of the world's order";
      sum += c.count;
      ++expected;
    }
    EXPECT_EQ(sum, Count(world));
  }
}

TEST(Census, OneContactLeavesThreeClassesOfRelationsByHand) {
  // None; one plane; two planes at a point, where nothing non-singular is left and two or more rows are in force.
  const Census census = TakeCensus(SingularWorld(1));
  ASSERT_EQ(census.classes.size(), 3u);
  EXPECT_EQ(census.classes[0].count + census.classes[1].count + census.classes[2].count, 1u + 18 + 48);
}

TEST(Census, TheSmallestClassHasTheFewestContactsOfThoseWithTheProperty) {
  const Census census = TakeCensus(AxisWorld(2));
  const auto fewest = [&](const std::function<bool(const MotionDof&)>& property) {
    const CensusClass* found = SmallestClass(census, property);
    return found == nullptr ? -1 : static_cast<int>(found->witness.contacts.size());
  };
  EXPECT_EQ(fewest([](const MotionDof&) { return true; }), 0);
  EXPECT_EQ(fewest([](const MotionDof& dof) { return dof.translation.detaching > 0; }), 1);
  EXPECT_EQ(fewest([](const MotionDof& dof) { return dof.rotation.detaching > 0; }), 2);
  EXPECT_EQ(fewest([](const MotionDof& dof) { return dof.all.constraining > 1; }), -1)
      << "needs three contacts";
}

TEST(LawsHoldThroughout, AWrongLawIsRefutedByItsSmallestCounterexampleARightOneHasACensus) {
  const Assertion right{{{"translation.maintaining", 1},
                         {"translation.detaching", 1},
                         {"translation.constraining", 1},
                         {"constant", -3}},
                        "zero"};
  // True of a free object and of one contact; two opposed ones constrain.
  const Assertion wrong{{{"translation.constraining", 1}}, "zero"};
  const Outcome holds = LawsHoldThroughout(AxisWorld(2), "test", {right}, "");
  EXPECT_EQ(holds.verdict, Verdict::kHoldsTo);
  ASSERT_EQ(holds.certificates.size(), 1u);
  const check::Answer answer = check::CheckCertificate(holds.certificates[0].json);
  EXPECT_TRUE(answer.accepted) << answer.why;
  EXPECT_EQ(answer.not_recounted, "");
  EXPECT_EQ(Counterexample(LawsHoldThroughout(AxisWorld(2), "test", {right, wrong}, "")).size(), 2u);
}

TEST(HoldsThroughout, ARightFormulaHoldsOnEveryRelation) {
  size_t tried = 0;
  const Outcome outcome =
      HoldsThroughout(AxisWorld(2), "test", [&](const ContactRelation& relation, const auto& d) {
        ++tried;
        return ByDefinition(relation).maintaining_rotation == d.rotation.maintaining;
      });
  EXPECT_EQ(outcome.verdict, Verdict::kHoldsTo);
  EXPECT_EQ(tried, Count(AxisWorld(2)));
  EXPECT_EQ(outcome.numbers, (std::vector<std::pair<std::string, long long>>{{"relations", 1540}}));
  EXPECT_TRUE(outcome.certificates.empty());
}

TEST(HoldsThroughout, AFormulaWrongForTwoContactsIsRefutedByTheFirstSuchPair) {
  // c_r = c_a - c_t holds up to one contact; two normals that face each other off one line refute it
  // [thesis, 2.2.1]. The definition's side of the comparison is the projected cone.
  const auto wrong = [](const ContactRelation& relation, const MotionDof&) {
    const Definitions d = ByDefinition(relation);
    return 3 - d.legal_rotation == (6 - d.legal_all) - (3 - d.legal_translation);
  };
  const auto contacts = Counterexample(HoldsThroughout(AxisWorld(2), "test", wrong));
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0]["point"], (nlohmann::json{-1, -1, -1, 1}));
  EXPECT_EQ(contacts[0]["planes"], (nlohmann::json{{1, 0, 0}}));
  EXPECT_EQ(contacts[1]["point"], (nlohmann::json{-1, -1, 0, 1}));
  EXPECT_EQ(contacts[1]["planes"], (nlohmann::json{{-1, 0, 0}}));
  EXPECT_EQ(HoldsThroughout(AxisWorld(1), "test", wrong).verdict, Verdict::kHoldsTo);
}

TEST(HoldsThroughout, EachEngineNumberPutOffByOneIsRefutedByTheEmptyRelation) {
  using Wrong = std::function<bool(const Definitions&, const MotionDof&)>;
  const std::vector<Wrong> formulas = {
      [](const auto& d, const auto& dof) { return 3 - d.legal_rotation == dof.rotation.constraining + 1; },
      [](const auto& d, const auto& dof) {
        return d.legal_rotation - d.maintaining_rotation == dof.rotation.detaching + 1;
      },
      [](const auto& d, const auto& dof) { return d.maintaining_rotation == dof.rotation.maintaining - 1; },
      [](const auto& d, const auto& dof) {
        return 3 - d.rank_g - d.maintaining_rotation == dof.rotation.detaching_type1 + 1;
      }};
  for (const Wrong& formula : formulas) {
    const auto contacts = Counterexample(
        HoldsThroughout(AxisWorld(2), "test", [&](const ContactRelation& relation, const auto& dof) {
          return formula(ByDefinition(relation), dof);
        }));
    EXPECT_EQ(contacts, nlohmann::json::array());
  }
}

TEST(HoldsThroughout, SwappedTypesOfDetachingRotationAreRefutedByTwoContacts) {
  // The fewest contacts with a detaching rotation are two, so that is where Type I and II first differ.
  const auto contacts = Counterexample(
      HoldsThroughout(AxisWorld(2), "test", [](const ContactRelation& relation, const MotionDof& dof) {
        const Definitions d = ByDefinition(relation);
        return 3 - d.rank_g - d.maintaining_rotation == dof.rotation.detaching_type2;
      }));
  EXPECT_EQ(contacts.size(), 2u);
}

TEST(FirstFailure, IsTheFirstInTheWorldsOrder) {
  const auto world = AxisWorld(2);
  for (const size_t place : {0u, 7u, 53u}) {
    const auto failure = FirstFailure(world, [&](const ContactRelation& relation, const MotionDof&) {
      return std::count(relation.contacts.begin(), relation.contacts.end(), world.contacts[place]) == 0;
    });
    ASSERT_TRUE(failure.has_value());
    EXPECT_EQ(*failure, (ContactRelation{{world.contacts[place]}}));
  }
  EXPECT_FALSE(FirstFailure(world, [](const auto&, const auto&) { return true; }).has_value());
}

}  // namespace
}  // namespace tact::provers

// The rules of [thesis, 2.3.1, 2.5, 2.6]; the peg's DOFs are those that contact_finder_test.cc finds.
#include "algebra/contact/dof_transition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tact::algebra {
namespace {

using enum DofIndex;
using enum SubSkill;

constexpr std::array<DofIndex, 6> kAll = {kMaintaining,         kDetaching,         kConstraining,
                                          kSingularMaintaining, kSingularDetaching, kSingularConstraining};

TranslationDof Translation(int m, int d, int c, int restricted) { return {m, d, c, restricted}; }

RotationDof Rotational(int m, int type1, int type2, int c, int restricted) {
  return {m, type1 + type2, type1, type2, c, restricted};
}

MotionDof Dof(bool singular, const TranslationDof& t, const RotationDof& r) {
  MotionDof dof;
  dof.singular = singular;
  dof.translation = t;
  dof.rotation = r;
  return dof;
}

const MotionDof kFree = Dof(false, Translation(3, 0, 0, 0), Rotational(3, 0, 0, 0, 0));
const MotionDof kEdgeOnFace = Dof(false, Translation(2, 1, 0, 1), Rotational(2, 1, 0, 0, 1));
const MotionDof kEdgeOnEdge = Dof(true, Translation(3, 0, 0, 2), Rotational(3, 0, 0, 0, 2));
const MotionDof kEdgeOnFaceAndWall = Dof(false, Translation(1, 2, 0, 2), Rotational(1, 2, 0, 0, 2));
const MotionDof kAtTheMouth = Dof(true, Translation(3, 0, 0, 2), Rotational(3, 0, 0, 0, 3));
const MotionDof kInTheSlot = Dof(false, Translation(2, 0, 1, 1), Rotational(1, 0, 0, 2, 2));
const MotionDof kHome = Dof(false, Translation(1, 1, 1, 2), Rotational(0, 1, 0, 2, 3));

TEST(DofTransition, TwentyOfThirtyKindsArePractical) {
  std::set<std::pair<DofIndex, DofIndex>> impractical;
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    for (const DofIndex a : kAll) {
      for (const DofIndex b : kAll) {
        if (a != b && !IsPractical({motion, a, b})) impractical.emplace(a, b);
      }
    }
  }
  const std::set<std::pair<DofIndex, DofIndex>> expected = {{kSingularMaintaining, kSingularDetaching},
                                                            {kSingularDetaching, kSingularMaintaining},
                                                            {kSingularMaintaining, kSingularConstraining},
                                                            {kSingularConstraining, kSingularMaintaining},
                                                            {kSingularDetaching, kSingularConstraining},
                                                            {kSingularConstraining, kSingularDetaching},
                                                            {kMaintaining, kConstraining},
                                                            {kConstraining, kMaintaining},
                                                            {kMaintaining, kSingularConstraining},
                                                            {kSingularConstraining, kMaintaining}};
  EXPECT_EQ(impractical, expected);
}

TEST(DofTransition, AnIndexThatFallsPairsWithEachThatRises) {
  const Transition t = AnalyzeTransition(kFree, kEdgeOnFace);
  EXPECT_EQ(t.dof_transitions, (std::vector<DofTransition>{{Motion::kTranslation, kMaintaining, kDetaching},
                                                           {Motion::kRotation, kMaintaining, kDetaching}}));
  EXPECT_FALSE(t.ambiguous);
  EXPECT_TRUE(AnalyzeTransition(kHome, kHome).dof_transitions.empty());
}

// Two fall and two rise in translation: four pairs, and nothing says which two belong together.
TEST(DofTransition, SeveralFallingAndSeveralRisingAreAmbiguous) {
  const MotionDof before = Dof(false, Translation(2, 1, 0, 1), kFree.rotation);
  MotionDof after = Dof(false, Translation(0, 2, 1, 3), kFree.rotation);
  EXPECT_FALSE(AnalyzeTransition(before, after).ambiguous);  // one falls, by two
  after = Dof(true, Translation(2, 1, 0, 3), kFree.rotation);
  const Transition t = AnalyzeTransition(before, after);
  EXPECT_TRUE(t.ambiguous);
  EXPECT_EQ(std::count_if(t.dof_transitions.begin(), t.dof_transitions.end(),
                          [](const DofTransition& d) { return d.motion == Motion::kTranslation; }),
            4);
}

TEST(DofTransition, MakeContactSelectsTheTypeThatRises) {
  EXPECT_EQ(AnalyzeTransition(kFree, kEdgeOnFace).sub_skills,
            (std::vector<SubSkill>{kMakeContactInTranslation, kType1MakeContactInRotation}));
  const MotionDof second = Dof(false, kFree.translation, Rotational(2, 0, 1, 0, 1));
  EXPECT_EQ(AnalyzeTransition(kFree, second).sub_skills,
            (std::vector<SubSkill>{kType2MakeContactInRotation}));
  const MotionDof both = Dof(false, kFree.translation, Rotational(1, 1, 1, 0, 2));
  EXPECT_EQ(AnalyzeTransition(kFree, both).sub_skills,
            (std::vector<SubSkill>{kType1MakeContactInRotation, kType2MakeContactInRotation}));
}

TEST(DofTransition, DetachContactIsSelectedFromDetachingAndFromSingularDetaching) {
  EXPECT_EQ(AnalyzeTransition(kEdgeOnFace, kFree).sub_skills,
            (std::vector<SubSkill>{kDetachContactInTranslation, kDetachContactInRotation}));
  const MotionDof singular = Dof(true, Translation(2, 1, 0, 3), Rotational(2, 1, 0, 0, 1));
  const std::vector<SubSkill> skills = AnalyzeTransition(singular, kFree).sub_skills;
  EXPECT_EQ(skills, (std::vector<SubSkill>{kDetachContactInTranslation, kDetachContactInRotation}));
}

// [thesis, 2.6]: a parallel edge-edge contact is a slide only if the restricted DOF rises.
TEST(DofTransition, SlideNeedsTheRestrictedDofToRise) {
  EXPECT_EQ(AnalyzeTransition(kEdgeOnFace, kEdgeOnEdge).sub_skills,
            (std::vector<SubSkill>{kSlideInTranslation, kSlideInRotation}));
  MotionDof flat = kEdgeOnEdge;
  flat.translation.restricted = 1;
  EXPECT_EQ(AnalyzeTransition(kEdgeOnFace, flat).sub_skills, (std::vector<SubSkill>{kSlideInRotation}));
  flat.rotation.restricted = 1;
  const Transition none = AnalyzeTransition(kEdgeOnFace, flat);
  EXPECT_TRUE(none.sub_skills.empty());
  EXPECT_NE(none.why.find("No slide in translation"), std::string::npos);
}

TEST(DofTransition, CriticalIsFromSingularMaintainingOrDetachingToConstraining) {
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    for (const DofIndex from :
         {kSingularMaintaining, kSingularDetaching, kSingularConstraining, kDetaching}) {
      MotionDof before = kFree, after = kFree;
      before.singular = from != kDetaching;
      const int d = from == kSingularDetaching || from == kDetaching ? 3 : 0,
                m = from == kSingularMaintaining ? 3 : 0;
      if (motion == Motion::kTranslation) {
        before.translation = Translation(m, d, 3 - m - d, 3);
        after.translation = Translation(0, 0, 3, 3);
      } else {
        before.rotation = Rotational(m, d, 0, 3 - m - d, 3);
        after.rotation = Rotational(0, 0, 0, 3, 3);
      }
      EXPECT_EQ(AnalyzeTransition(before, after).critical,
                from == kSingularMaintaining || from == kSingularDetaching)
          << ToString(motion) << " from " << ToString(from);
    }
  }
}

// Free, edge on the block's top, on its rim, edge on a wall, two edges at the mouth, at the mouth upright, in the
// slot, home.
TEST(DofTransition, TheSevenOfThePegInTheSlot) {
  const std::vector<MotionDof> states = {
      kFree, kEdgeOnFace, kEdgeOnEdge, kEdgeOnFace, kEdgeOnFaceAndWall, kAtTheMouth, kInTheSlot, kHome};
  std::vector<Transition> transitions;
  for (size_t i = 0; i + 1 < states.size(); ++i) {
    transitions.push_back(AnalyzeTransition(states[i], states[i + 1]));
  }
  using Skills = std::vector<SubSkill>;
  EXPECT_EQ(transitions[0].sub_skills, (Skills{kMakeContactInTranslation, kType1MakeContactInRotation}));
  EXPECT_EQ(transitions[1].sub_skills, (Skills{kSlideInTranslation, kSlideInRotation}));
  EXPECT_EQ(transitions[2].sub_skills, Skills{});
  EXPECT_EQ(transitions[3].sub_skills, (Skills{kMakeContactInTranslation, kType1MakeContactInRotation}));
  EXPECT_EQ(transitions[4].sub_skills, Skills{kSlideInRotation});  // restricted: 2 to 2, and 2 to 3
  EXPECT_EQ(transitions[5].sub_skills, Skills{});
  EXPECT_EQ(transitions[6].sub_skills, (Skills{kMakeContactInTranslation, kType1MakeContactInRotation}));
  for (size_t i = 0; i < transitions.size(); ++i) {
    EXPECT_EQ(transitions[i].critical, i == 5) << i;
    EXPECT_TRUE(transitions[i].practical) << i;
    EXPECT_FALSE(transitions[i].why.empty()) << i;
  }
}

TEST(DofTransition, SingularRelationsFillTheSingularIndices) {
  const auto t = Indices(kEdgeOnFace, Motion::kTranslation), s = Indices(kAtTheMouth, Motion::kRotation);
  EXPECT_EQ(t, (std::array<int, 6>{2, 1, 0, 0, 0, 0}));
  EXPECT_EQ(s, (std::array<int, 6>{0, 0, 0, 3, 0, 0}));
  EXPECT_EQ(Restricted(kAtTheMouth, Motion::kTranslation), 2);
  EXPECT_EQ(Restricted(kAtTheMouth, Motion::kRotation), 3);
}

}  // namespace
}  // namespace tact::algebra

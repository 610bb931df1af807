#include "robot/recognition/transition_validity.h"

#include <gtest/gtest.h>

#include "tests/robot/recognition/peg_states.h"

namespace tact::recognition {
namespace {

struct PegTransitions : PegStates {
  PegTransitions() {
    for (const auto& state : demonstration.states) {
      const auto found = ContactsInPose(models, state.pose.pose, state.where);
      relations.push_back(
          {PointContactsOf(found, models.moving, models.fixed), algebra::ComputeMotionDof(found.relation)});
    }
  }
  std::vector<RelationSeen> relations;
};

// [thesis, 2.8.1]: the transitions of the peg insertion are the valid ones.
TEST_F(PegTransitions, TheSevenOfThePegInsertionAreValid) {
  for (size_t i = 0; i + 1 < relations.size(); ++i) {
    const TransitionValidity validity = ValidityOf(relations[i], relations[i + 1]);
    EXPECT_TRUE(validity.valid()) << demonstration.states[i].name << ": " << ToString(validity);
  }
}

TEST_F(PegTransitions, ThereAndBackAreAlikeForInclusion) {
  for (const auto& a : relations) {
    for (const auto& b : relations) EXPECT_EQ(ValidityOf(a, b).included, ValidityOf(b, a).included);
    EXPECT_TRUE(ValidityOf(a, a).valid());
    EXPECT_TRUE(ValidityOf(a, relations.front()).included);  // nothing touches there
  }
}

// By hand: standing on the bottom with its sides in the slot (H) it has no contact with the edge it slid on (B).
TEST_F(PegTransitions, FromTheFaceOutsideToTheBottomNothingIsIncluded) {
  EXPECT_FALSE(ValidityOf(relations[1], relations[7]).included);
}

}  // namespace
}  // namespace tact::recognition

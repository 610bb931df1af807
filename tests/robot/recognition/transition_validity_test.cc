#include "robot/recognition/transition_validity.h"

#include <gtest/gtest.h>

#include "tests/robot/recognition/peg_states.h"

namespace tact::recognition {
namespace {

struct PegTransitions : PegStates {
  PegTransitions() {
    for (const auto& state : demonstration.states) {
      const auto found = ContactsInPose(models, state.pose.pose, state.where);
      primitives.push_back(found.primitives);
      dofs.push_back(ComputeMotionDof(found.relation));
    }
  }
  TransitionValidity Between(size_t i, size_t j) const {
    return ValidityOf({primitives[i], dofs[i]}, {primitives[j], dofs[j]}, models.moving, models.fixed);
  }
  std::vector<Primitives> primitives;
  std::vector<algebra::MotionDof> dofs;
};

// [thesis, 2.8.1]: the transitions of the peg insertion are valid ones.
TEST_F(PegTransitions, TheSevenOfThePegInsertionAreValid) {
  for (size_t i = 0; i + 1 < dofs.size(); ++i)
    EXPECT_TRUE(Between(i, i + 1).valid())
        << demonstration.states[i].name << ": " << ToString(Between(i, i + 1));
}

TEST_F(PegTransitions, ThereAndBackAreAlikeForInclusion) {
  for (size_t i = 0; i < dofs.size(); ++i) {
    for (size_t j = 0; j < dofs.size(); ++j) EXPECT_EQ(Between(i, j).included, Between(j, i).included);
    EXPECT_TRUE(Between(i, i).valid());
    EXPECT_TRUE(Between(i, 0).included);  // nothing touches in the first
  }
}

// By hand: standing on the bottom with its sides in the slot (H) nothing is left of the edge on the face outside (B).
TEST_F(PegTransitions, FromTheFaceOutsideToTheBottomNothingIsIncluded) {
  EXPECT_FALSE(Between(1, 7).included);
  EXPECT_NE(ToString(Between(1, 7)).find("neither"), std::string::npos);
}

}  // namespace
}  // namespace tact::recognition

#include "robot/recognition/point_contact.h"

#include <gtest/gtest.h>

#include "robot/perception/random_numbers.h"
#include "tests/robot/recognition/peg_states.h"

namespace tact::recognition {
namespace {

using joint::Transform;

TEST_F(PegStates, EveryPointContactHasNoGapInItsState) {
  for (const auto& state : demonstration.states) {
    const auto contacts = ContactsIn(state);
    EXPECT_EQ(contacts.empty(), state.name == "A") << state.name;
    for (const PointContact& contact : contacts)
      EXPECT_NEAR(GapOf(contact, moving, fixed, ToTransform(state.pose.pose)).gap, 0, 1e-12)
          << state.name << ": " << ToString(contact);
  }
}

TEST_F(PegStates, ARowTimesATwistIsTheGapsRate) {
  perception::RandomNumbers random(7);
  for (const auto& state : demonstration.states) {
    const Transform X = ToTransform(state.pose.pose);
    for (const PointContact& contact : ContactsIn(state)) {
      Eigen::Matrix<double, 6, 1> aside;
      for (int i = 0; i < 6; ++i) aside[i] = 0.02 * random.Gaussian();
      const Transform near = Moved(X, aside);
      const GapRow row = GapOf(contact, moving, fixed, near).row;
      for (int i = 0; i < 6; ++i) {
        Eigen::Matrix<double, 6, 1> step = Eigen::Matrix<double, 6, 1>::Zero();
        step[i] = 1e-6;
        const double rate = (GapOf(contact, moving, fixed, Moved(near, step)).gap -
                             GapOf(contact, moving, fixed, Moved(near, -step)).gap) /
                            2e-6;
        EXPECT_NEAR(row[i], rate, 1e-7) << state.name << ": " << ToString(contact) << ", " << i;
      }
    }
  }
}

// State H: the shaft stands on the bottom, its two sides in the slot.
TEST_F(PegStates, LiftedUpTheGapIsTheHeight) {
  const auto& state = demonstration.states.back();
  Transform X = ToTransform(state.pose.pose);
  X.p.z() += 0.5;
  int on_bottom = 0;
  for (const PointContact& contact : ContactsIn(state)) {
    const Gap gap = GapOf(contact, moving, fixed, X);
    if (std::abs(gap.row[5]) < 0.5) continue;
    EXPECT_NEAR(gap.gap, 0.5, 1e-12) << ToString(contact);
    ++on_bottom;
  }
  EXPECT_GE(on_bottom, 4);
}

}  // namespace
}  // namespace tact::recognition

#include "robot/recognition/exact_pose.h"

#include <gtest/gtest.h>

#include "robot/perception/random_numbers.h"
#include "tests/robot/recognition/peg_states.h"

namespace tact::recognition {
namespace {

using joint::Transform;

TEST_F(PegStates, FromDoublesBackToTheSameContacts) {
  perception::RandomNumbers random(11);
  for (const auto& state : demonstration.states) {
    const auto contacts = ContactsIn(state);
    Eigen::Matrix<double, 6, 1> off;
    for (int i = 0; i < 6; ++i) off[i] = 1e-9 * random.Gaussian();
    const ExactPose exact =
        FindExactPose(models.moving, models.fixed, contacts, Moved(ToTransform(state.pose.pose), off));
    ASSERT_TRUE(exact.X_FM) << state.name << ": " << exact.why;
    EXPECT_EQ(exact.contacts, contacts) << state.name;
    const Transform X = ToTransform(*exact.X_FM), given = ToTransform(state.pose.pose);
    EXPECT_LT((X.p - given.p).norm(), 0.02) << state.name;
    EXPECT_LT((X.R - given.R).norm(), 0.002) << state.name;
  }
}

// Turned about the vertical by an angle without a rational tangent, standing on its foot's face.
TEST_F(PegStates, WhatIsLeftFreeIsRounded) {
  const std::vector<PointContact> contacts = ContactsIn(demonstration.states.back());
  std::vector<PointContact> bottom;
  for (const PointContact& contact : contacts) {
    const Gap gap = GapOf(contact, moving, fixed, ToTransform(demonstration.states.back().pose.pose));
    if (gap.row[5] > 0.5) bottom.push_back(contact);
  }
  Transform X = ToTransform(demonstration.states.back().pose.pose);
  X.R = joint::RotationExp({0, 0, 0.3}) * X.R;
  X.p += Eigen::Vector3d(0, 0, 100);  // the gaps bring it back down, where the slot's walls are in the way
  const ExactPose exact = FindExactPose(models.moving, models.fixed, bottom, X);
  EXPECT_FALSE(exact.X_FM);
  EXPECT_NE(exact.why.find("penetrates"), std::string::npos) << exact.why;
}

TEST_F(PegStates, WithoutContactsAnyRationalPoseNearbyWillDo) {
  Transform X = ToTransform(demonstration.states.front().pose.pose);
  X.R = joint::RotationExp({0.1, 0.2, 0.3}) * X.R;
  X.p += Eigen::Vector3d(0, 0, 50);
  const ExactPose exact = FindExactPose(models.moving, models.fixed, {}, X);
  ASSERT_TRUE(exact.X_FM) << exact.why;
  EXPECT_LT((ToTransform(*exact.X_FM).R - X.R).norm(), 1e-3);
  EXPECT_LT((ToTransform(*exact.X_FM).p - X.p).norm(), 1e-3);
}

}  // namespace
}  // namespace tact::recognition

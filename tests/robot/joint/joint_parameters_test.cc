#include "robot/joint/joint_parameters.h"

#include <gtest/gtest.h>

#include "robot/joint/simulated_joint.h"

namespace tact::joint {
namespace {

TEST(NamedParameters, SayWhatThePosesLeaveOpen) {
  Simulation simulation(10);
  const Transform X = simulation.Frame(0.1);
  const std::vector<Transform> still(20, X);
  const JointFit fit = FitMaximumLikelihood(JointType::kRevolute, still);
  EXPECT_LT(fit.rank, JointParameters(JointType::kRevolute));
  bool open = false;
  for (const NamedParameter& parameter : NamedParametersOf(fit, X)) open |= !parameter.determined;
  EXPECT_TRUE(open);
}

// Names of a revolute joint at the truth are its own: the direction, and the centre about which A's origin turns.
TEST(NamedParameters, OfACleanJointAreItsOwn) {
  Simulation simulation(11);
  const Joint truth = simulation.AnyJoint(JointType::kRevolute);
  const auto poses = simulation.Poses(truth, 30, NoiseLaw::kNone);
  const JointFit fit = FitMaximumLikelihood(JointType::kRevolute, poses);
  const auto named = NamedParametersOf(fit, poses.front());
  ASSERT_EQ(named.size(), 4u);
  EXPECT_LT(named[0].value.head<3>().cross(truth.X_AJ.R.col(2)).norm(), 1e-9);
  EXPECT_LT(named[1].value.head<3>().cross(truth.X_BJ.R.col(2)).norm(), 1e-9);
  for (const Transform& X_BA : poses) {
    EXPECT_LT((X_BA * Eigen::Vector3d(named[2].value.head<3>()) - named[3].value.head<3>()).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace tact::joint

#include "robot/joint/robust.h"

#include <gtest/gtest.h>

#include "robot/joint/joint_parameters.h"
#include "robot/joint/simulated_joint.h"

namespace tact::joint {
namespace {

class RobustJoint : public testing::TestWithParam<JointType> {};

// 30 % wrong, anywhere or all shifted alike: as good as maximum likelihood of the right ones, within 3 % in error.
TEST_P(RobustJoint, SurvivesWrongPoses) {
  const JointType type = GetParam();
  for (const bool alike : {false, true}) {
    Simulation simulation(12);
    double robust_square = 0, right_square = 0;
    for (int trial = 0; trial < 5; ++trial) {
      const Joint truth = simulation.AnyJoint(type);
      auto poses = simulation.Poses(truth, 150, NoiseLaw::kGaussian);
      const Transform shift{RotationExp(simulation.Direction()), 0.3 * simulation.Direction()};
      std::vector<Transform> right;
      std::vector<std::size_t> wrong;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        if (i % 10 < 3) {
          poses[i] = alike ? shift * poses[i] : simulation.Frame(simulation.Uniform(0.2, 0.5));
          wrong.push_back(i);
        } else {
          right.push_back(poses[i]);
        }
      }
      const RobustFit robust = FitRobustly(type, poses);
      // Wrong poses that happen to fit are no error; right ones called wrong are.
      for (const std::size_t outlier : robust.outliers) EXPECT_LT(outlier % 10, 3u) << NameOf(type);
      const JointFit fit = FitMaximumLikelihood(type, right);
      robust_square +=
          DistanceTo(truth, ClimbLikelihood(robust.fit.joint, right, {fit.noise, {}, 1}), right.front())
              .squared;
      right_square += DistanceTo(truth, fit, right.front()).squared;
      EXPECT_GE(robust.outliers.size() + 2, wrong.size()) << NameOf(type) << (alike ? " alike" : " anywhere");
    }
    EXPECT_LT(robust_square, 1.06 * right_square) << NameOf(type);
  }
}

INSTANTIATE_TEST_SUITE_P(AllTypes, RobustJoint, testing::ValuesIn(kJointTypes), [](const auto& type) {
  std::string name(NameOf(type.param));
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace tact::joint

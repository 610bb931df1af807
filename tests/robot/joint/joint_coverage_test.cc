#include <gtest/gtest.h>

#include "robot/joint/joint_parameters.h"
#include "robot/joint/robust.h"
#include "tests/robot/joint/simulated_joint.h"

namespace tact::joint {
namespace {

// 95 % of chi square with as many degrees [any table].
constexpr std::array kNinetyFive = {0.0,    3.841,  5.991,  7.815,  9.488,  11.070,
                                    12.592, 14.067, 15.507, 16.919, 18.307, 19.675};

// The share of trials in which the 95 % region holds the truth.
double Coverage(JointType type, NoiseLaw law, int trials, unsigned seed) {
  Simulation simulation(seed);
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Joint truth = simulation.AnyJoint(type);
    const auto poses = simulation.Poses(truth, 100, law);
    const JointFit fit = FitMaximumLikelihood(type, poses);
    const Distance distance = DistanceTo(truth, fit, poses.front());
    EXPECT_EQ(distance.freedom, JointParameters(type));
    held += distance.squared < kNinetyFive[static_cast<std::size_t>(distance.freedom)];
  }
  return static_cast<double>(held) / trials;
}

// 100 trials: 0.95 +- 4 standard deviations of the count.
TEST(JointCoverage, RegionsHoldTheTruth) {
  for (const JointType type : kJointTypes) {
    const int trials = type == JointType::kTwoAxis ? 40 : 100;
    EXPECT_GT(Coverage(type, NoiseLaw::kRectangular, trials, 7), 0.95 - 4 * std::sqrt(0.95 * 0.05 / trials))
        << NameOf(type);
  }
}

TEST(FullJointCoverage, NinetyFivePercentRegionsHoldNinetyThreeToNinetySeven) {
  for (const JointType type : kJointTypes) {
    const double coverage = Coverage(type, NoiseLaw::kGaussian, 10000, 8);
    EXPECT_GT(coverage, 0.93) << NameOf(type);
    EXPECT_LT(coverage, 0.97) << NameOf(type);
  }
}

TEST(MaximumLikelihood, ScalesAreThoseOfTheNoise) {
  Simulation simulation(9);
  for (const JointType type : kJointTypes) {
    const auto poses = simulation.Poses(simulation.AnyJoint(type), 400, NoiseLaw::kGaussian);
    const JointFit fit = FitMaximumLikelihood(type, poses);
    EXPECT_TRUE(fit.converged) << NameOf(type);
    EXPECT_NEAR(fit.noise.translation / kScale.translation, 1, 0.2) << NameOf(type);
    // A spherical joint shows its orientations' noise by the arm alone.
    EXPECT_NEAR(fit.noise.rotation / kScale.rotation, 1, type == JointType::kSpherical ? 0.5 : 0.2)
        << NameOf(type);
  }
}

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

class RobustJoint : public testing::TestWithParam<JointType> {};

// 30 % wrong, anywhere or all shifted alike: as good as maximum likelihood of the right ones, within 3 % in error; none missed.
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

#include "robot/joint/maximum_likelihood.h"

#include <gtest/gtest.h>

#include "robot/joint/joint_parameters.h"
#include "robot/joint/simulated_joint.h"

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

}  // namespace
}  // namespace tact::joint

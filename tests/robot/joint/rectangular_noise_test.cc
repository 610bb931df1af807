#include "robot/joint/rectangular_noise.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "robot/joint/joint_parameters.h"
#include "robot/joint/simulated_joint.h"

namespace tact::joint {
namespace {

constexpr NoiseBounds kBounds{kLargestTurn, kLargestMove};

// One pose's likelihood by summing over its coordinate in small steps, the errors linear in it.
double BruteForce(const Joint& joint, const Coordinates& q, const Transform& X_BA) {
  const Vector6 error = PoseError(joint, q, X_BA);
  const Vector6 along = JacobianAt(joint, q).coordinates.col(0);
  constexpr int kSteps = 400000;
  const double range = 2 * (along.head<3>().norm() > 0 ? kLargestTurn / along.head<3>().norm() : 1);
  const double reach = std::min(range, 2 * kLargestMove / along.tail<3>().norm());
  double sum = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double x = reach * (i + 0.5) / kSteps;
    const double turn = (error - x * along).head<3>().squaredNorm(),
                 move = (error - x * along).tail<3>().squaredNorm();
    if (turn < kLargestTurn * kLargestTurn && move < kLargestMove * kLargestMove) sum += 1 / (turn * move);
  }
  return std::log(sum * reach / kSteps) - std::log(kLargestTurn * kLargestMove);
}

TEST(RectangularLikelihood, IsTheIntegralOverTheCoordinate) {
  Simulation simulation(30);
  for (const JointType type : {JointType::kRevolute, JointType::kScrew, JointType::kPrismatic}) {
    for (int trial = 0; trial < 5; ++trial) {
      const Joint joint = simulation.AnyJoint(type);
      const auto poses = simulation.Poses(joint, 2, NoiseLaw::kRectangular);
      JointFit fit;
      fit.joint = joint;
      for (const Transform& X : poses) fit.coordinates.push_back(CoordinatesNear(joint, X));
      const RectangularLikelihood likelihood(fit, poses);
      double brute = 0;
      for (std::size_t i = 0; i < 2; ++i) brute += BruteForce(joint, fit.coordinates[i], poses[i]);
      EXPECT_NEAR(likelihood.At(ParameterVector::Zero(JointParameters(type)), kBounds), brute, 1e-2)
          << NameOf(type);
    }
  }
}

TEST(PosteriorMean, BeatsLeastSquaresUnderItsLaw) {
  Simulation simulation(31);
  double likelihood = 0, posterior = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const Joint truth = simulation.AnyJoint(JointType::kRevolute, 0.001);
    const auto poses = simulation.Poses(truth, 100, NoiseLaw::kRectangular);
    const auto error = [&truth](const JointFit& fit) {
      return fit.joint.X_BJ.R.col(2).cross(truth.X_BJ.R.col(2)).norm();
    };
    PosteriorOptions options{kBounds, 1, 6000};
    const PosteriorMean mean = FitPosteriorMean(JointType::kRevolute, poses, options);
    EXPECT_EQ(mean.outside, 0u);
    posterior += error(mean.fit);
    likelihood += error(FitMaximumLikelihood(JointType::kRevolute, poses));
  }
  EXPECT_LT(posterior, likelihood / 1.4);
}

TEST(PosteriorMean, TheSameSeedGivesTheSameAnswer) {
  Simulation simulation(32);
  const auto poses = simulation.Poses(simulation.AnyJoint(JointType::kPrismatic), 40, NoiseLaw::kRectangular);
  const PosteriorOptions options{{}, 5, 2000};
  const PosteriorMean a = FitPosteriorMean(JointType::kPrismatic, poses, options);
  const PosteriorMean b = FitPosteriorMean(JointType::kPrismatic, poses, options);
  EXPECT_EQ(a.fit.joint.X_BJ.p, b.fit.joint.X_BJ.p);
  EXPECT_NEAR(a.bounds.rotation / kLargestTurn, 1, 0.3);
  EXPECT_NEAR(a.bounds.translation / kLargestMove, 1, 0.3);
}

TEST(PosteriorMean, RefusesTypesOfMoreDof) {
  const std::vector<Transform> poses(10);
  EXPECT_THROW(FitPosteriorMean(JointType::kPlanar, poses), PreconditionError);
}

}  // namespace
}  // namespace tact::joint

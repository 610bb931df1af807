#include "robot/joint/thesis_estimator.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>
#include <random>

#include "algebra/error.h"
#include "robot/joint/least_squares.h"
#include "robot/joint/two_axis_search.h"

namespace tact::joint {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double Between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Vector3d Gaussian(double sd) {
    std::normal_distribution<double> normal(0, sd);
    return {normal(engine_), normal(engine_), normal(engine_)};
  }
  Transform Pose() { return {RotationExp(Gaussian(2)), Gaussian(0.1)}; }

 private:
  std::mt19937 engine_;
};

struct Case {
  Joint truth;
  std::vector<Transform> poses;
};

// Poses in equal steps of the coordinate from 0 to span, two-axis at random, with Gaussian noise of sd radian and sd *
// 0.1 metre.
Case Draws(JointType type, double span, int count, double sd, unsigned seed) {
  Draw draw(seed);
  Case drawn{{type, draw.Pose(), draw.Pose(), type == JointType::kScrew ? 0.02 : 0, 0}, {}};
  for (int i = 0; i < count; ++i) {
    Coordinates q(span * i / (count - 1), 0, 0);
    if (type == JointType::kTwoAxis) q = {draw.Between(0, span), draw.Between(0, span), 0};
    const Transform X_BA = PoseAt(drawn.truth, q);
    drawn.poses.push_back({RotationExp(draw.Gaussian(sd)) * X_BA.R, X_BA.p + draw.Gaussian(0.1 * sd)});
  }
  return drawn;
}

double Between(const Vector3d& a, const Vector3d& b) { return a.cross(b).norm(); }

TEST(ThesisEstimator, WithoutNoiseEachJointIsFound) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const JointType type : {JointType::kPrismatic, JointType::kRevolute, JointType::kScrew}) {
      const double span = type == JointType::kPrismatic ? 0.2 : 2;
      const auto [truth, poses] = Draws(type, span, 30, 0, seed);
      const Joint found = FitAsInThesis(type, poses).joint;
      EXPECT_LT(Between(found.X_AJ.R.col(2), truth.X_AJ.R.col(2)), 1e-5) << NameOf(type) << seed;
      EXPECT_LT(Between(found.X_BJ.R.col(2), truth.X_BJ.R.col(2)), 1e-5) << NameOf(type) << seed;
      for (const Transform& X_BA : poses) {
        const Transform again = PoseAt(found, CoordinatesNear(found, X_BA));
        EXPECT_LT((again.p - X_BA.p).norm(), 1e-5) << NameOf(type) << seed;
        EXPECT_LT((again.R - X_BA.R).norm(), 1e-5) << NameOf(type) << seed;
      }
      if (type != JointType::kScrew) continue;
      const bool same =
          found.X_BJ.R.col(2).dot(truth.X_BJ.R.col(2)) > 0;  // turned about -z by -q, the pitch stays
      EXPECT_NEAR(found.pitch, truth.pitch, 1e-5) << same << seed;
    }
  }
}

// Twin: the singular value decomposition knows no initial guess.
TEST(ThesisEstimator, ConjugateGradientsEndAtTheGlobalOptimum) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    for (const JointType type : {JointType::kPrismatic, JointType::kRevolute, JointType::kScrew}) {
      const auto poses = Draws(type, type == JointType::kPrismatic ? 0.2 : 2, 40, 0.03, seed).poses;
      const ThesisFit fit = FitAsInThesis(type, poses);
      const Joint best = FitLeastSquares(type, poses);
      EXPECT_TRUE(fit.converged) << NameOf(type) << seed;
      EXPECT_LT(Between(fit.joint.X_AJ.R.col(2), best.X_AJ.R.col(2)), 2e-5) << NameOf(type) << seed;
      EXPECT_LT(Between(fit.joint.X_BJ.R.col(2), best.X_BJ.R.col(2)), 2e-5) << NameOf(type) << seed;
      const Vector3d apart = fit.joint.X_BJ.p - best.X_BJ.p;
      const Vector3d l = best.X_BJ.R.col(2);
      EXPECT_LT(apart.cross(l).norm(), 2e-5) << NameOf(type) << seed;
      EXPECT_NEAR(fit.joint.pitch, best.pitch, 2e-5) << NameOf(type) << seed;
    }
  }
}

TEST(ThesisEstimator, TheTwoAxisSumFromTheIdentityIsTheLeastOne) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto poses = Draws(JointType::kTwoAxis, std::numbers::pi / 2, 100, 0.03, seed).poses;
    const ThesisFit fit = FitAsInThesis(JointType::kTwoAxis, poses);
    EXPECT_NEAR(std::sqrt(fit.value / 100), FindTwoAxes(poses).rms, 1e-6) << seed;
  }
}

TEST(ThesisEstimator, ItsValueIsTheThesisSum) {
  const auto poses = Draws(JointType::kRevolute, 1, 25, 0.05, 3).poses;
  const ThesisFit fit = FitAsInThesis(JointType::kRevolute, poses);
  double sum = 0;
  for (const Transform& X_BA : poses)
    sum += 1 - fit.joint.X_BJ.R.col(2).dot(X_BA.R * fit.joint.X_AJ.R.col(2));
  // X_AJ is set so that the first corrected pose has angle zero: its z is l_A up to rounding.
  EXPECT_NEAR(fit.value, sum, 1e-9);
}

TEST(ThesisEstimator, AScrewIsFollowedPastHalfTurns) {
  const auto [truth, poses] = Draws(JointType::kScrew, 9, 60, 0.02, 5);
  EXPECT_NEAR(FitAsInThesis(JointType::kScrew, poses).joint.pitch, truth.pitch, 5e-4);
}

RC_GTEST_PROP(ThesisEstimator, RollPitchYawIsThePrintedMatrixWithItsLastRowCorrected, ()) {
  const auto angle = [] { return *rc::gen::inRange(-3000, 3000) / 1000.0; };
  const double a = angle(), b = angle(), c = angle();
  Matrix3d expected;  // [thesis, eq. (4.26)]
  expected << cos(a) * cos(b), cos(a) * sin(b) * sin(c) - sin(a) * cos(c),
      cos(a) * sin(b) * cos(c) + sin(a) * sin(c), sin(a) * cos(b), sin(a) * sin(b) * sin(c) + cos(a) * cos(c),
      sin(a) * sin(b) * cos(c) - cos(a) * sin(c), -sin(b), cos(b) * sin(c), cos(b) * cos(c);
  const Matrix3d R = RollPitchYaw({a, b, c});
  RC_ASSERT((R - expected).norm() < 1e-12);
  RC_ASSERT((RollPitchYaw(AnglesOf(R)) - R).norm() < 1e-7);
}

RC_GTEST_PROP(ThesisEstimator, ACorrectedOrientationMapsTheAxisByTheLeastTurn, ()) {
  Draw draw(*rc::gen::inRange(0, 100000));
  const Matrix3d R = draw.Pose().R;
  const AxisPair axes{draw.Gaussian(1).normalized(), draw.Gaussian(1).normalized()};
  const Matrix3d corrected = CorrectedOrientation(R, axes);
  RC_ASSERT((corrected * axes.l_A - axes.l_B).norm() < 1e-7);
  const double turned = RotationLog(corrected * R.transpose()).norm();
  RC_ASSERT(std::abs(turned - std::acos(axes.l_B.dot(R * axes.l_A))) < 1e-6);
}

// Brute: every pair, by the angle between.
TEST(ThesisEstimator, TheQuarterTurnPairIsTheNearest) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const auto poses = Draws(JointType::kRevolute, 0.5 + 0.1 * seed, 25, 0.05, seed).poses;
    double least = 10;
    std::pair<std::size_t, std::size_t> nearest;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (std::size_t j = i + 1; j < poses.size(); ++j) {
        const double angle = RotationLog(poses[i].R.transpose() * poses[j].R).norm();
        if (std::abs(angle - std::numbers::pi / 2) >= least) continue;
        least = std::abs(angle - std::numbers::pi / 2);
        nearest = {i, j};
      }
    }
    EXPECT_EQ(NearestQuarterTurn(poses), nearest) << seed;
  }
}

TEST(ThesisEstimator, MethodAIsExactWithoutNoise) {
  const auto [truth, poses] = Draws(JointType::kRevolute, 2, 20, 0, 7);
  const AxisPair axes = MethodA(poses);
  EXPECT_LT(Between(axes.l_A, truth.X_AJ.R.col(2)), 1e-9);
  EXPECT_LT(Between(axes.l_B, truth.X_BJ.R.col(2)), 1e-9);
}

TEST(ThesisEstimator, JointsTheThesisDoesNotTreatAreRefused) {
  const std::vector<Transform> poses(3);
  EXPECT_THROW(FitAsInThesis(JointType::kPlanar, poses), PreconditionError);
}

}  // namespace
}  // namespace tact::joint

#include "robot/joint/least_squares.h"

#include <gtest/gtest.h>

#include "robot/joint/simulated_joint.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Eigen::Vector3d;

double Distance(const Transform& a, const Transform& b) { return (a.R - b.R).norm() + (a.p - b.p).norm(); }

TEST(LeastSquares, FindsWhatMadeCleanPoses) {
  Simulation simulation(2);
  for (const JointType type : kJointTypes) {
    for (int trial = 0; trial < 10; ++trial) {
      const auto poses = simulation.Poses(simulation.AnyJoint(type), 30, NoiseLaw::kNone);
      const Joint joint = FitLeastSquares(type, poses);
      for (const Transform& X : poses) {
        EXPECT_LT(Distance(X, PoseAt(joint, CoordinatesNear(joint, X))), 1e-7) << NameOf(type);
      }
    }
  }
}

// [thesis, eq. (4.16)]: no other pair of axes has a larger sum of l_B . R_i l_A, here among all that turns
// between the two lead to from random starts.
TEST(LeastSquares, NoLocalSearchBeatsTheAxes) {
  Simulation simulation(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto poses =
        simulation.Poses(simulation.AnyJoint(JointType::kRevolute), 12, NoiseLaw::kRectangular);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Transform& X : poses) sum += X.R;
    const Joint joint = FitLeastSquares(JointType::kRevolute, poses);
    const double best = joint.X_BJ.R.col(2).dot(sum * joint.X_AJ.R.col(2));
    for (int start = 0; start < 20; ++start) {
      Vector3d l_A = simulation.Direction(), l_B;
      for (int turn = 0; turn < 100; ++turn)
        l_B = (sum * l_A).normalized(), l_A = (sum.transpose() * l_B).normalized();
      EXPECT_LE(l_B.dot(sum * l_A), best + 1e-9);
    }
  }
}

// [thesis, eq. (4.38)] on a grid of the half sphere, v the best for each u.
TEST(TwoAxisSearch, NoPointOfAFineGridIsBetter) {
  Simulation simulation(4);
  for (int trial = 0; trial < 3; ++trial) {
    const auto poses = simulation.Poses(simulation.AnyJoint(JointType::kTwoAxis), 15, NoiseLaw::kRectangular);
    const TwoAxes found = FindTwoAxes(poses);
    for (int i = 0; i <= 40; ++i) {
      for (int k = 0; k < 80; ++k) {
        const double polar = i * std::numbers::pi / 80, turn = k * std::numbers::pi / 40;
        const Vector3d u(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
        Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
        for (const Transform& X : poses) form += X.R.transpose() * u * u.transpose() * X.R;
        EXPECT_GE(std::sqrt(std::max(0.0, EigenOf(form).values[0]) / 15), found.rms - 1e-12);
      }
    }
  }
}

TEST(LeastSquares, MovingOneLinksFrameMovesTheAnswerAlong) {
  Simulation simulation(5);
  for (const JointType type : kJointTypes) {
    const auto poses = simulation.Poses(simulation.AnyJoint(type), 40, NoiseLaw::kGaussian);
    const Transform X_CB = simulation.Frame(0.3);
    std::vector<Transform> moved;
    for (const Transform& X_BA : poses) moved.push_back(X_CB * X_BA);
    const Joint joint = FitLeastSquares(type, poses), other = FitLeastSquares(type, moved);
    // Both allow the same poses: compared where the link was seen.
    for (const Transform& X_BA : poses) {
      const Transform here = X_CB * PoseAt(joint, CoordinatesNear(joint, X_BA));
      EXPECT_LT(Distance(here, PoseAt(other, CoordinatesNear(other, X_CB * X_BA))), 1e-6) << NameOf(type);
    }
  }
}

TEST(LeastSquares, APassGivesWhatAnArrayGives) {
  Simulation simulation(6);
  for (const JointType type : kJointTypes) {
    const auto poses = simulation.Poses(simulation.AnyJoint(type), 25, NoiseLaw::kGaussian);
    const Joint array = FitLeastSquares(type, poses);
    const Joint pass = FitLeastSquares(type, [&poses](const std::function<void(const Transform&)>& take) {
      for (const Transform& X : poses) take(X);
    });
    EXPECT_EQ(Distance(array.X_BJ, pass.X_BJ) + Distance(array.X_AJ, pass.X_AJ), 0) << NameOf(type);
  }
}

TEST(Unwrap, GoesOnPastAHalfTurn) {
  std::vector<double> angles;
  for (int i = 0; i < 100; ++i) angles.push_back(std::remainder(0.3 * i, 2 * std::numbers::pi));
  Unwrap(angles);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(angles[static_cast<std::size_t>(i)], 0.3 * i, 1e-12);
}

}  // namespace
}  // namespace tact::joint

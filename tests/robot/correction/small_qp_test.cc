#include "robot/correction/small_qp.h"

#include <gtest/gtest.h>

#include "robot/perception/random_numbers.h"

namespace tact::correction {
namespace {

// By hand: nearest to (3, 0) of x + y = 1 with y >= 0 and x <= 0.5 is (0.5, 0.5).
TEST(SmallQp, AnExampleByHand) {
  SmallQp qp;
  qp.B = Eigen::MatrixXd::Identity(2, 2);
  qp.g = Eigen::Vector2d(-3, 0);
  qp.E = Eigen::RowVector2d(1, 1);
  qp.e = Eigen::VectorXd::Constant(1, 1);
  qp.C = (Eigen::MatrixXd(2, 2) << 0, 1, -1, 0).finished();
  qp.c = Eigen::Vector2d(0, -0.5);
  qp.weight = 100;
  const SmallQpAnswer answer = Solve(qp, 1e-12);
  EXPECT_TRUE(answer.ended);
  EXPECT_NEAR(answer.x[0], 0.5, 1e-9);
  EXPECT_NEAR(answer.x[1], 0.5, 1e-9);
  EXPECT_NEAR(answer.violation, 0, 1e-9);
}

// Conditions of Karush, Kuhn and Tucker, sufficient where the sum is convex.
TEST(SmallQp, AnswersAreOptimal) {
  perception::RandomNumbers random(5);
  for (int round = 0; round < 300; ++round) {
    const Eigen::Index n = 6, m = round % 5, k = 1 + round % 30;
    const auto matrix = [&](Eigen::Index rows, Eigen::Index columns) {
      Eigen::MatrixXd a(rows, columns);
      for (double& x : a.reshaped()) x = random.Gaussian();
      return a;
    };
    SmallQp qp;
    const Eigen::MatrixXd root = matrix(n, n);
    qp.B = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    qp.g = matrix(n, 1), qp.E = matrix(m, n), qp.e = matrix(m, 1), qp.C = matrix(k, n), qp.c = matrix(k, 1);
    qp.weight = 1e3;
    const SmallQpAnswer answer = Solve(qp, 1e-11);
    ASSERT_TRUE(answer.ended);
    const double s = answer.violation;
    EXPECT_LT((qp.E * answer.x - qp.e).cwiseAbs().sum(), 1e-8);
    EXPECT_GT((qp.C * answer.x - qp.c).minCoeff(), -s - 1e-8);
    EXPECT_GE(answer.inequalities.minCoeff(), 0);
    const Eigen::VectorXd left = qp.B * answer.x + qp.g - qp.E.transpose() * answer.equalities -
                                 qp.C.transpose() * answer.inequalities;
    EXPECT_LT(left.norm(), 1e-7 * (1 + answer.inequalities.sum()));
    const Eigen::VectorXd above = qp.C * answer.x - qp.c + Eigen::VectorXd::Constant(k, s);
    EXPECT_LT(above.cwiseProduct(answer.inequalities).cwiseAbs().maxCoeff(),
              1e-6 * (1 + answer.inequalities.sum()));
    // The violation is paid for: its multiplier and the inequalities' sum to its price.
    EXPECT_LE(answer.inequalities.sum(), qp.weight + s + 1e-6);
    if (s > 1e-6) EXPECT_NEAR(answer.inequalities.sum(), qp.weight + s, 1e-6 * qp.weight);
  }
}

}  // namespace
}  // namespace tact::correction

#include "robot/joint/conjugate_gradient.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace tact::joint {
namespace {

constexpr CgUpdate kUpdates[] = {CgUpdate::kFletcherReeves, CgUpdate::kPolakRibiere};

// Sum of weight_i (x_i - i)^2.
Objective Bowl(const Unknowns& weights) {
  return [weights](const Unknowns& x, Unknowns* gradient) {
    double value = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double off = x[i] - static_cast<double>(i);
      value += weights[i] * off * off;
      (*gradient)[i] = 2 * weights[i] * off;
    }
    return value;
  };
}

RC_GTEST_PROP(ConjugateGradient, ABowlsBottomIsNearAfterTwiceAsManyStepsAsItHasUnknowns, ()) {
  const int n = *rc::gen::inRange(1, 7);
  Unknowns weights(n), start(n);
  for (int i = 0; i < n; ++i) {
    weights[i] = *rc::gen::inRange(1, 100);
    start[i] = *rc::gen::inRange(-50, 50);
  }
  for (const CgUpdate update : kUpdates) {
    // In exact arithmetic, after n; each line's minimum is found to a ten-thousandth of its slope only.
    Unknowns gradient(n);
    const double before = Bowl(weights)(start, &gradient);
    const CgMinimum soon =
        MinimizeByConjugateGradient(Bowl(weights), start, {.update = update, .most_iterations = 2 * n});
    RC_ASSERT(soon.value <= 1e-6 * before);
    const CgMinimum minimum = MinimizeByConjugateGradient(Bowl(weights), start, {.update = update});
    RC_ASSERT(minimum.converged);
    for (int i = 0; i < n; ++i) RC_ASSERT(std::abs(minimum.x[i] - i) < 1e-4);
  }
}

// Rosenbrock's valley and start; the minimum is 0 at (1, 1).
double Valley(const Unknowns& x, Unknowns* gradient) {
  const double a = 1 - x[0], b = x[1] - x[0] * x[0];
  *gradient << -2 * a - 400 * x[0] * b, 200 * b;
  return a * a + 100 * b * b;
}

Unknowns ValleyStart() {
  Unknowns start(2);
  start << -1.2, 1;
  return start;
}

TEST(ConjugateGradient, RosenbrocksValleyIsFollowedToItsEnd) {
  for (const CgUpdate update : kUpdates) {
    const CgMinimum minimum = MinimizeByConjugateGradient(Valley, ValleyStart(), {.update = update});
    EXPECT_TRUE(minimum.converged);
    EXPECT_NEAR(minimum.x[0], 1, 1e-4);
    EXPECT_NEAR(minimum.x[1], 1, 1e-4);
  }
}

TEST(ConjugateGradient, AtAStationaryPointItStays) {
  Unknowns weights(2), start(2);
  weights << 1, 3;
  start << 0, 1;
  const CgMinimum minimum = MinimizeByConjugateGradient(Bowl(weights), start);
  EXPECT_TRUE(minimum.converged);
  EXPECT_EQ(minimum.iterations, 0);
  EXPECT_EQ(minimum.x, start);
}

TEST(ConjugateGradient, ALooseToleranceEndsEarlierAndHigher) {
  const CgMinimum fine = MinimizeByConjugateGradient(Valley, ValleyStart());
  const CgMinimum coarse = MinimizeByConjugateGradient(Valley, ValleyStart(), {.tolerance = 0.5});
  EXPECT_LT(coarse.iterations, fine.iterations);
  EXPECT_GT(coarse.value, fine.value);
}

TEST(ConjugateGradient, OutOfIterationsIsNotConverged) {
  Unknowns weights(3), start(3);
  weights << 1, 10, 100;
  start << 5, 5, 5;
  EXPECT_FALSE(MinimizeByConjugateGradient(Bowl(weights), start, {.most_iterations = 1}).converged);
}

}  // namespace
}  // namespace tact::joint

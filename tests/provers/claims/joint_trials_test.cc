#include "provers/claims/joint_trials.h"

#include <gtest/gtest.h>

#include "provers/claims/printed_table.h"

namespace tact::provers {
namespace {

using joint::JointType;

TrialSetup Revolute(Placing placing) { return {JointType::kRevolute, 1.5, 50, placing, 0.03, 0}; }

TEST(JointTrials, ASeedIsATrialAndAnotherSeedAnother) {
  const Trial once = DrawTrial(Revolute(Placing::kRandom), 5),
              again = DrawTrial(Revolute(Placing::kRandom), 5),
              other = DrawTrial(Revolute(Placing::kRandom), 6);
  for (size_t i = 0; i < 50; ++i) EXPECT_EQ(once.noisy[i].R, again.noisy[i].R);
  EXPECT_NE(once.noisy[0].R, other.noisy[0].R);
}

// Neighbouring seeds must not give one stream, shifted.
TEST(JointTrials, NeighbouringSeedsAreUncorrelated) {
  double sum = 0;
  constexpr int kTrials = 4000;
  Eigen::Vector3d before = DrawTrial(Revolute(Placing::kEqual), 0).truth.X_AJ.R.col(2);
  for (std::uint64_t seed = 1; seed < kTrials; ++seed) {
    const Eigen::Vector3d next = DrawTrial(Revolute(Placing::kEqual), seed).truth.X_AJ.R.col(2);
    sum += before.dot(next) / kTrials;
    before = next;
  }
  EXPECT_LT(std::abs(sum),
            4 / std::sqrt(3.0 * kTrials));  // a component's variance is 1/3: four standard deviations
}

TEST(JointTrials, TheNoiseIsTheThesisLaw) {
  std::vector<double> turns, shifts, along;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Trial trial = DrawTrial(Revolute(Placing::kRandom), seed);
    for (size_t i = 0; i < trial.exact.size(); ++i) {
      const Eigen::Vector3d w = joint::RotationLog(trial.noisy[i].R * trial.exact[i].R.transpose());
      turns.push_back(w.norm() / kMostTurn);
      shifts.push_back((trial.noisy[i].p - trial.exact[i].p).norm() / kMostShift);
      along.push_back(w.normalized().z());
    }
  }
  // Uniform on [0, 1]: mean 1/2, SD 1/sqrt(12); on [-1, 1]: 0 and 1/sqrt(3). Four standard deviations of 10000 samples.
  for (const auto* sample : {&turns, &shifts}) {
    const Moments moments = MomentsOf(*sample);
    EXPECT_NEAR(moments.mean, 0.5, 4 * 0.2887 / 100);
    EXPECT_NEAR(moments.sd, 0.2887, 0.006);
    EXPECT_LE(*std::max_element(sample->begin(), sample->end()), 1 + 1e-9);
  }
  EXPECT_NEAR(MomentsOf(along).mean, 0, 4 * 0.5774 / 100);
  EXPECT_NEAR(MomentsOf(along).sd, 0.5774, 0.012);
}

TEST(JointTrials, ExactPosesAreTheJointsAndLieAsTheyShould) {
  const Trial equal = DrawTrial(Revolute(Placing::kEqual), 1);
  for (size_t i = 0; i < 50; ++i) {
    const auto q = CoordinatesNear(equal.truth, equal.exact[i]);
    EXPECT_NEAR(q[0], 1.5 * static_cast<double>(i) / 49, 1e-9);
    EXPECT_LT((PoseAt(equal.truth, q).p - equal.exact[i].p).norm(), 1e-12);
  }
  EXPECT_NEAR(equal.truth.X_AJ.p.norm(), 0.03, 1e-12);
  const Trial random = DrawTrial(Revolute(Placing::kRandom), 1);
  double last = -1;
  for (const auto& X_BA : random.exact) {
    const double q = CoordinatesNear(random.truth, X_BA)[0];
    EXPECT_GE(q, last);
    EXPECT_LE(q, 1.5);
    last = q;
  }
}

TEST(JointTrials, AGridHasEachPairOfAnglesOnce) {
  const Trial grid = DrawTrial({JointType::kTwoAxis, 0.9, 100, Placing::kGrid, 0, 0}, 2);
  std::vector<std::pair<long, long>> cells;
  for (const auto& X_BA : grid.exact) {
    const auto q = CoordinatesNear(grid.truth, X_BA);
    EXPECT_NEAR(q[0] * 10, std::round(q[0] * 10), 1e-6);
    cells.emplace_back(std::lround(q[0] * 10), std::lround(q[1] * 10));
  }
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(std::unique(cells.begin(), cells.end()), cells.end());
  EXPECT_EQ(cells.size(), 100u);
}

TEST(JointTrials, ResultsStandInTheOrderOfSeeds) {
  const auto rows = RunTrials(1000, 2, [](std::uint64_t seed, double* values) {
    values[0] = static_cast<double>(seed);
    values[1] = -static_cast<double>(seed);
  });
  for (size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(rows[0][i], static_cast<double>(i));
    EXPECT_EQ(rows[1][i], -static_cast<double>(i));
  }
}

}  // namespace
}  // namespace tact::provers

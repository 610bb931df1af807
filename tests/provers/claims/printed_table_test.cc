#include "provers/claims/printed_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tact::provers {
namespace {

std::vector<double> Gaussian(int count, double mean, double sd, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(mean, sd);
  std::vector<double> sample(static_cast<size_t>(count));
  for (double& x : sample) x = normal(engine);
  return sample;
}

TEST(PrintedTable, MomentsOfASmallSampleByHand) {
  const std::vector<double> sample = {1, 2, 3, 6};
  const Moments moments = MomentsOf(sample);
  EXPECT_EQ(moments.count, 4u);
  EXPECT_DOUBLE_EQ(moments.mean, 3);
  EXPECT_DOUBLE_EQ(moments.sd, std::sqrt(14 / 3.0));
  // second moment 3.5, fourth (16 + 1 + 0 + 81) / 4 = 24.5: sqrt((2 - 1) / 4)
  EXPECT_DOUBLE_EQ(moments.sd_spread, 0.5);
}

// The deviations of true cells are standard normal: mean square one.
TEST(PrintedTable, DeviationsOfTrueCellsHaveMeanSquareOne) {
  double of_mean = 0, of_sd = 0;
  constexpr int kCells = 400;
  for (unsigned seed = 0; seed < kCells; ++seed) {
    const Moments printed = MomentsOf(Gaussian(kPrintedTrials, 5, 2, 2 * seed));
    const Deviation d = Compare({"", printed.mean, printed.sd}, MomentsOf(Gaussian(500, 5, 2, 2 * seed + 1)));
    of_mean += d.of_mean * d.of_mean / kCells;
    of_sd += d.of_sd * d.of_sd / kCells;
  }
  // The mean of 400 squares spreads by sqrt(2 / 400) = 0.07.
  EXPECT_NEAR(of_mean, 1, 0.3);
  EXPECT_NEAR(of_sd, 1, 0.3);
}

TEST(PrintedTable, ACellOffByATenthOfItsSdIsFoundOutFromManyTrials) {
  const Moments rerun = MomentsOf(Gaussian(10000, 5, 2, 1));
  EXPECT_TRUE(Compare({"", 5, 2}, rerun).agrees());
  EXPECT_FALSE(Compare({"", 5.3, 2}, rerun).agrees());
  EXPECT_FALSE(Compare({"", 5, 2.25}, rerun).agrees());
}

Reading Of(const std::string& name, double mean) {
  return {name, {MomentsOf(Gaussian(4000, 1, 0.5, 1)), MomentsOf(Gaussian(4000, mean, 0.5, 2))}};
}

TEST(PrintedTable, TheVerdictIsThatOfTheBestReading) {
  const std::vector<PrintedCell> printed = {{"first", 1, 0.5}, {"second", 2, 0.5}};
  const std::vector<Reading> readings = {Of("wrong", 3), Of("right", 2)};
  EXPECT_EQ(BestReading(printed, readings), 1u);
  EXPECT_EQ(JudgeTable("table", printed, readings).verdict, Verdict::kReproduced);
  const Outcome wrong = JudgeTable("table", printed, {readings[0]});
  EXPECT_EQ(wrong.verdict, Verdict::kNotReproduced);
  EXPECT_EQ(wrong.numbers.back().second, 1);
}

TEST(PrintedTable, ExponentOfAPowerLaw) {
  Moments y0{100, 8, 0.8, 0}, y1{100, 2, 0.2, 0};
  const Exponent exponent = ExponentBetween(10, y0, 20, y1);
  EXPECT_DOUBLE_EQ(exponent.value, -2);
  EXPECT_NEAR(exponent.half_width, 1.96 * 0.01 * std::sqrt(2.0) / std::log(2.0), 1e-12);
}

}  // namespace
}  // namespace tact::provers

#include "robot/perception/part_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tact::perception {
namespace {

// A strip of 100 by 5 points of unit spacing.
std::vector<Eigen::Vector3d> Strip() {
  std::vector<Eigen::Vector3d> points;
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 5; ++y) points.emplace_back(x, y, 0);
  }
  return points;
}

TEST(PartEvidence, CostIsTheSquaredDistanceBeyondNoise) {
  const Surface strip = SurfaceOf(Strip());
  // By hand: 2.5 deviations off the plane cost 6.25 - 4; two cost nothing; four cost the most.
  for (const auto& [off, cost] :
       std::vector<std::pair<double, double>>{{2.5, 2.25}, {2, 0}, {4, kMostCost}}) {
    const joint::Transform X_TS{Eigen::Matrix3d::Identity(), {0, 0, 0.1 * off}};
    for (const double c : CostOf(strip, strip, X_TS, 0.1)) EXPECT_NEAR(c, cost, 1e-9);
  }
  // What meets nothing, or a surface that stands across, costs the most.
  for (const double c : CostOf(strip, strip, {Eigen::Matrix3d::Identity(), {0, 0, 50}}, 0.1))
    EXPECT_EQ(c, kMostCost);
  for (const double c : CostOf(strip, strip, {joint::RotationExp({M_PI / 2, 0, 0}), {0, 0, 0}}, 0.1))
    EXPECT_EQ(c, kMostCost);
}

TEST(PartEvidence, NeighboursDecideNearbyAndFadeFarAway) {
  const Surface strip = SurfaceOf(Strip());
  std::vector<double> evidence(strip.points.size(), 0);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    if (strip.points[i].x() < 20) evidence[i] = 3;
    if (strip.points[i].x() > 79) evidence[i] = -3;
  }
  evidence[2] = -3;  // one point alone is outvoted
  const std::vector<Part> parts = PartsBy(MeanField(strip, evidence));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double x = strip.points[i].x();
    if (i == 2) {
      EXPECT_NE(parts[i], Part::kSecond);
    }
    if (x < 19 && x > 2) {
      EXPECT_EQ(parts[i], Part::kFirst) << x;
    }
    if (x > 30 && x < 69) {
      EXPECT_EQ(parts[i], Part::kUndecided) << x;
    }
    if (x > 80) {
      EXPECT_EQ(parts[i], Part::kSecond) << x;
    }
  }
}

TEST(PartEvidence, ExchangedEvidenceExchangesTheParts) {
  const Surface strip = SurfaceOf(Strip());
  std::vector<double> evidence;
  for (std::size_t i = 0; i < strip.points.size(); ++i) evidence.push_back(std::sin(0.05 * double(i)));
  const std::vector<double> field = MeanField(strip, evidence);
  for (double& e : evidence) e = -e;
  const std::vector<double> exchanged = MeanField(strip, evidence);
  for (std::size_t i = 0; i < field.size(); ++i) EXPECT_EQ(field[i], -exchanged[i]);
}

}  // namespace
}  // namespace tact::perception

#include "robot/perception/surface.h"

#include <gtest/gtest.h>

#include <limits>

#include "algebra/error.h"
#include "robot/perception/random_numbers.h"

namespace tact::perception {
namespace {

// A grid of unit spacing on the plane z = x / 2.
std::vector<Eigen::Vector3d> Grid(double noise) {
  RandomNumbers random(1);
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.5, 0, 1).normalized();
  std::vector<Eigen::Vector3d> points;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y)
      points.push_back(Eigen::Vector3d(x, y, 0.5 * x) + noise * random.Gaussian() * normal);
  }
  return points;
}

TEST(Surface, APlaneHasItsNormalItsSpacingAndNoNoise) {
  const Surface surface = SurfaceOf(Grid(0));
  EXPECT_NEAR(surface.spacing, 1, 1e-12);
  EXPECT_NEAR(surface.noise, 0, 1e-12);
  for (const auto& n : surface.normals)
    EXPECT_NEAR(std::abs(n.dot(Eigen::Vector3d(-0.5, 0, 1).normalized())), 1, 1e-12);
  for (std::uint32_t i = 0; i < surface.points.size(); ++i) EXPECT_EQ(surface.neighbours[i][0], i);
}

TEST(Surface, NoiseIsMeasuredAndAveraged) {
  const Surface surface = SurfaceOf(Grid(0.05));
  EXPECT_NEAR(surface.noise, 0.05, 0.005);  // 1600 points that share neighbours
  double squares = 0;
  for (const auto& p : surface.points)
    squares += std::pow(p.dot(Eigen::Vector3d(-0.5, 0, 1).normalized()), 2) / 1600;
  // A plane through 16 points averages by 4 in the middle, by 2 at the margin.
  EXPECT_LT(std::sqrt(squares), 0.5 * 0.05);
}

TEST(Surface, TooFewPointsAndPointsNowhereAreRefused) {
  std::vector<Eigen::Vector3d> points = Grid(0);
  EXPECT_THROW(SurfaceOf(std::span(points).first(kFewestPoints - 1)), PreconditionError);
  points[7].y() = std::numeric_limits<double>::quiet_NaN();
  try {
    SurfaceOf(points);
    FAIL() << "accepted";
  } catch (const PreconditionError& error) {
    EXPECT_STREQ(error.what(), "expected finite coordinates, got others in point 8");
  }
}

TEST(EvenlySpread, TakesAllOfFewAndSomeOfMany) {
  EXPECT_EQ(EvenlySpread(3, 10), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(EvenlySpread(10, 4), (std::vector<std::uint32_t>{0, 2, 5, 7}));
  EXPECT_TRUE(EvenlySpread(0, 4).empty());
}

}  // namespace
}  // namespace tact::perception

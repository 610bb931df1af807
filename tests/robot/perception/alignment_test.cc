#include "robot/perception/alignment.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "tests/robot/perception/plier_example.h"

namespace tact::perception {
namespace {

std::vector<Vector3d> Moved(const Transform& X, const std::vector<Vector3d>& points) {
  std::vector<Vector3d> moved;
  for (const Vector3d& p : points) moved.push_back(X * p);
  return moved;
}

// How far a motion carries points of a hand-sized object at 0.7 m wrong, about.
double Error(const Transform& found, const Transform& expected) {
  const Transform error = expected.Inverse() * found;
  const Vector3d middle(0, 0, 0.7);
  return (error * middle - middle).norm() + 0.05 * joint::RotationLog(error.R).norm();
}

std::vector<Vector3d> OneScan(double opening, double noise, std::uint64_t seed) {
  PlierStudy study = SmallStudy(seed, noise);
  study.openings = {opening};
  return ScanPlier(study)[0].seen.points;
}

TEST(Alignment, AKnownMotionComesBackExactly) {
  const std::vector<Vector3d> points = OneScan(0.3, 0, 1);
  const Surface source = SurfaceOf(points);
  RandomNumbers random(3);
  for (int trial = 0; trial < 2; ++trial) {
    const Vector3d middle(0, 0, 0.7);
    const Eigen::Matrix3d R = joint::RotationExp(0.3 * random.InBall());
    const Transform X_TS{R, middle - R * middle + 0.02 * random.InBall()};
    const Alignment found = FindAlignment(source, SurfaceOf(Moved(X_TS, points)));
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.inliers, 1);
    EXPECT_LT(Error(found.X_TS, X_TS), 1e-9);
  }
}

TEST(Alignment, OfTwoMotionsOneWinsNotTheirMean) {
  PlierStudy study = SmallStudy(2);
  study.openings = {0.05, 0.45};
  const std::vector<PlierScan> scans = ScanPlier(study);
  const Alignment found = FindAlignment(SurfaceOf(scans[0].seen.points), SurfaceOf(scans[1].seen.points));
  const auto opened = [](double angle) {
    return Transform{joint::RotationExp({0, 0, angle}), Vector3d::Zero()};
  };
  const Transform first = scans[1].X_CL * scans[0].X_CL.Inverse();
  const Transform second = scans[1].X_CL * opened(0.4) * scans[0].X_CL.Inverse();
  EXPECT_LT(std::min(Error(found.X_TS, first), Error(found.X_TS, second)), 1e-3);
  EXPECT_GT(found.inliers, 0.5);
  EXPECT_LT(found.inliers, 0.75);
}

TEST(Alignment, FarFromTheTargetNothingIsFound) {
  const Surface surface = SurfaceOf(OneScan(0.3, 0, 1));
  const Alignment found = Align(surface, surface, {Eigen::Matrix3d::Identity(), Vector3d(1, 0, 0)});
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.inliers, 0);
  EXPECT_THROW(Align(Surface{}, surface, {}), PreconditionError);
}

}  // namespace
}  // namespace tact::perception

#include "robot/perception/part_joint.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "robot/perception/random_numbers.h"
#include "tests/robot/perception/plier_example.h"

namespace tact::perception {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

const Vector3d kPoint(0.01, -0.02, 0.7), kDirection = Vector3d(0.3, -0.2, -1).normalized();
const std::vector<Vector3d> kCentre = {Vector3d(0, 0, 0.7)};  // stands for a scan: its centroid counts

Transform Turned(double angle) {
  const Eigen::Matrix3d R = joint::RotationExp(angle * kDirection);
  return {R, kPoint - R * kPoint};
}

// Five states as an error-free division finds them.
Division ExactDivision() {
  Division division;
  RandomNumbers random(1);
  for (int i = 0; i < 5; ++i) {
    DividedScan scan;
    const Transform put{joint::RotationExp(0.1 * random.InBall()), 0.01 * random.InBall()};
    if (i > 0) scan.X_S0 = {put, put * Turned(0.12 * i)};
    scan.unit_covariances.fill(Matrix6::Zero());
    division.scans.push_back(scan);
  }
  return division;
}

TEST(PartJoint, ExactMotionsGiveTheExactAxis) {
  const PartAxis axis = AxisOf(ExactDivision(), kCentre);
  EXPECT_LT(axis.direction.cross(kDirection).norm(), 1e-9);
  EXPECT_GT(axis.direction.dot(kDirection), 0);  // the angles are positive
  EXPECT_LT(ErrorOf(axis, kPoint, kDirection).point, 1e-9);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(axis.angles[i], 0.12 * double(i), 1e-9);
  EXPECT_EQ(axis.direction_error, 0);
}

TEST(PartJoint, ItsCovarianceIsThatOfTheErrors) {
  // Errors of the motions drawn from their covariance, the first scan's shared: e^T C^-1 e has the mean 4 and the deviation
  // sqrt(8 / 400) of the mean of 400.
  Matrix6 unit = Matrix6::Zero();
  unit.diagonal() << 4e2, 2e2, 1e2, 0.8, 0.3, 0.3;
  Matrix6 to_origin = Matrix6::Identity();  // from about the centroid
  to_origin.bottomLeftCorner<3, 3>() << 0, -0.7, 0, 0.7, 0, 0, 0, 0, 0;
  unit = Matrix6(to_origin * unit * to_origin.transpose());
  const Matrix6 root = unit.llt().matrixL();
  RandomNumbers random(7);
  const auto twist = [&](double noise) {
    Vector6 g;
    for (double& value : g) value = noise * random.Gaussian();
    return Vector6(root * g);
  };
  double sum = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    Division division = ExactDivision();
    const std::array<Vector6, 2> shared = {twist(5e-5), twist(5e-5)};
    for (std::size_t i = 0; i < 5; ++i) {
      DividedScan& scan = division.scans[i];
      scan.noise = 5e-5;
      scan.unit_covariances.fill(unit);
      if (i == 0) continue;
      for (std::size_t part = 0; part < 2; ++part) {
        const Vector6 error = shared[part] + twist(5e-5);
        scan.X_S0[part] = scan.X_S0[part] * Transform{joint::RotationExp(error.head<3>()), error.tail<3>()};
      }
    }
    const PartAxis axis = AxisOf(division, kCentre);
    sum += ErrorOf(axis, kPoint, kDirection).squared;
  }
  EXPECT_NEAR(sum / kTrials, 4, 5 * std::sqrt(8.0 / kTrials));
}

TEST(PartJoint, ThePinOfAScannedPlierIsFound) {
  const std::vector<PlierScan> scans = ScanPlier(SmallStudy(3));
  const auto points = PointsOf(scans);
  const Division division = DivideTwoParts(points);
  ASSERT_EQ(division.cannot_tell, "");
  const PartAxis axis = AxisOf(division, points[0]);
  const AxisError error = ErrorOf(axis, scans[0].X_CL.p, scans[0].X_CL.R.col(2));
  EXPECT_LT(error.direction, 0.04);  // some 0.6 degrees are expected
  EXPECT_LT(error.point, 0.0008);    // and 0.2 mm
  EXPECT_LT(error.squared, 18.5);    // 99.9 % of chi squared with four degrees of freedom
  for (std::size_t i = 0; i < scans.size(); ++i) EXPECT_NEAR(axis.angles[i], scans[i].opening, 0.004);
}

TEST(FullPartJoint, NinetyFivePercentRegionsHoldThePin) {
  int inside = 0;
  constexpr int kTrials = 40;
  for (std::uint64_t seed = 201; seed < 201 + kTrials; ++seed) {
    const std::vector<PlierScan> scans = ScanPlier(SmallStudy(seed));
    const auto points = PointsOf(scans);
    const Division division = DivideTwoParts(points);
    ASSERT_EQ(division.cannot_tell, "") << seed;
    const PartAxis axis = AxisOf(division, points[0]);
    inside += ErrorOf(axis, scans[0].X_CL.p, scans[0].X_CL.R.col(2)).squared <
              9.488;  // chi squared with four degrees of freedom
  }
  EXPECT_GE(inside, 33);  // of 40 at 95 %, fewer come once in a thousand times
}

}  // namespace
}  // namespace tact::perception

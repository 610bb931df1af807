#include "robot/joint/coordinate_spread.h"

#include <cmath>
#include <numbers>

#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

const double kLogTwoPi = std::log(2 * std::numbers::pi);
constexpr double kMargin = 0.1;  // metre: a wrong pose may lie this far outside the box of all
constexpr double kLeastInformation =
    1e-12;  // of a coordinate that moves nothing, 1 / radian^2 or 1 / metre^2

// Rotation vectors stretch what left turns measure: log of the volume of left turns that a unit of vectors makes.
double LogTurnVolume(const Coordinates& q) {
  const double angle = q.norm();
  return angle < 1e-4 ? -angle * angle / 12 : std::log(2 * (1 - std::cos(angle)) / (angle * angle));
}

}  // namespace

CoordinateSpread SpreadOf(int dof, std::span<const Coordinates> coordinates,
                          std::span<const PoseEquations> equations, std::span<const double> weights) {
  CoordinateSpread spread{dof, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0};
  if (dof == 0) return spread;
  const auto weight = [weights](std::size_t i) { return weights.empty() ? 1 : weights[i]; };
  double count = 0;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    spread.mean += weight(i) * coordinates[i];
    count += weight(i);
  }
  spread.mean /= count;
  // Coordinates that the joint does not have are given the spread of their unit, which cancels.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(), information = covariance;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Eigen::Vector3d q = coordinates[i] - spread.mean;
    covariance.noalias() += weight(i) / count * q * q.transpose();
    information.noalias() += weight(i) / count * equations[i].T.transpose() * equations[i].T;
  }
  for (int i = dof; i < 3; ++i) covariance(i, i) = information(i, i) = 1;
  // In units of the coordinates' own uncertainty no component is below one.
  const SymmetricEigen3 own = EigenOf(information);
  const Eigen::Vector3d scale = own.values.cwiseMax(kLeastInformation).cwiseSqrt();
  const Eigen::Matrix3d whiten = scale.asDiagonal() * own.vectors.transpose();
  const SymmetricEigen3 components = EigenOf(whiten * covariance * whiten.transpose());
  const Eigen::Vector3d variances = components.values.cwiseMax(1.0);
  const Eigen::Matrix3d rows = components.vectors.transpose() * whiten;
  spread.precision = rows.transpose() * variances.cwiseInverse().asDiagonal() * rows;
  spread.log_normalizer = scale.array().log().sum() - (dof * kLogTwoPi + variances.array().log().sum()) / 2;
  return spread;
}

double LogDensity(const CoordinateSpread& spread, JointType type, const Coordinates& q,
                  const PoseEquations& equations, const NoiseScale& noise) {
  const Eigen::Vector3d off = q - spread.mean;
  const double coordinates = spread.log_normalizer - off.dot(spread.precision * off) / 2 -
                             (type == JointType::kSpherical ? LogTurnVolume(q) : 0);
  double log_volume = 0;
  for (int i = 0; i < spread.dof; ++i) log_volume += equations.T(i, i) > 0 ? std::log(equations.T(i, i)) : 0;
  return -equations.Squares() / 2 - 3 * (kLogTwoPi + std::log(noise.rotation) + std::log(noise.translation)) +
         spread.dof * kLogTwoPi / 2 - log_volume + coordinates;
}

double LogAnywhere(std::span<const Transform> poses) {
  Eigen::Vector3d low = poses.front().p, high = low;
  for (const Transform& X_BA : poses) low = low.cwiseMin(X_BA.p), high = high.cwiseMax(X_BA.p);
  const double orientations = 8 * std::numbers::pi * std::numbers::pi;
  return -std::log(orientations * ((high - low).array() + kMargin).prod());
}

double LogMixture(double density, double anywhere, double share) {
  const double good = std::log1p(-share) + density, bad = std::log(share) + anywhere;
  return std::max(good, bad) + std::log1p(std::exp(-std::abs(good - bad)));
}

}  // namespace tact::joint

#include "robot/joint/residual_correlation.h"

#include <algorithm>
#include <array>

#include "robot/joint/joint_parameters.h"

namespace tact::joint {
namespace {

constexpr double kMostShare = 0.2;  // of the poses: longer correlations cannot be seen in so few
// An autocorrelation of white noise lies within this many times 1 / sqrt(N).
constexpr double kChance = 3;

double CorrelationTime(const std::vector<Eigen::Vector3d>& series) {
  const std::size_t count = series.size();
  double square = 0;
  for (const Eigen::Vector3d& value : series) square += value.squaredNorm();
  if (count < 10 || square == 0) return 1;
  const auto at = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < count; ++i) sum += series[i].dot(series[i - lag]);
    return sum / square;
  };
  if (at(1) < kChance / std::sqrt(3.0 * static_cast<double>(count))) return 1;
  double time = 1;
  for (std::size_t lag = 1; lag + 1 < count; lag += 2) {
    const double pair = at(lag) + at(lag + 1);
    if (pair <= 0) break;
    time += 2 * pair;
  }
  return std::clamp(time, 1.0, std::max(1.0, kMostShare * static_cast<double>(count)));
}

}  // namespace

double ResidualCorrelation(const JointFit& fit, std::span<const Transform> poses,
                           std::span<const double> weights) {
  std::array<std::vector<Eigen::Vector3d>, 2> series;
  const std::vector<Residual> residuals = ResidualsOf(fit, poses);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!weights.empty() && weights[i] < 0.5) continue;
    series[0].push_back(residuals[i].rotation);
    series[1].push_back(residuals[i].translation);
  }
  return std::max(CorrelationTime(series[0]), CorrelationTime(series[1]));
}

}  // namespace tact::joint

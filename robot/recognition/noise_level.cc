#include "robot/recognition/noise_level.h"

#include <algorithm>
#include <cmath>

#include "robot/recognition/pose_metric.h"

namespace tact::recognition {
namespace {

using Eigen::Vector3d;
using joint::Transform;

constexpr double kMedianOfChi3 = 1.5382;        // of the length of three Gaussian errors of deviation one
constexpr double kMedianOfHalfNormal = 0.6745;  // of the size of one
/// Share of the smaller solid's smallest extent: who dips in deeper is not noisy but somewhere else.
constexpr double kDeepest = 0.25;

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double SmallestExtent(const SolidF& solid) {
  Vector3d low = solid.vertices.front(), high = low;
  for (const Vector3d& p : solid.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).minCoeff();
}

std::optional<double> Repeatability(const input::RecordedDemonstration& recording, const SolidF& fixed) {
  std::vector<Transform> poses;
  for (const input::RecordedScene& scene : recording.scenes) {
    if (scene.X_CF) poses.push_back(*scene.X_CF);
  }
  constexpr size_t kLeastPoses = 3;
  if (poses.size() < kLeastPoses) return std::nullopt;
  const PoseMetric metric(fixed);
  // The pose in the middle: from which the others are nearest.
  double best = HUGE_VAL;
  for (const Transform& centre : poses) {
    std::vector<double> ways;
    for (const Transform& pose : poses) ways.push_back(metric.Distance(centre, pose));
    best = std::min(best, Median(std::move(ways)));
  }
  return std::sqrt(2) * best / kMedianOfChi3;
}

// Depths of the vertices of one solid inside the other, X the pose of the first in the second.
void AddDepths(const ProximitySolid& vertices, const ProximitySolid& around, const Transform& X,
               double deepest, std::vector<double>* depths) {
  for (const Vector3d& vertex : vertices.solid().vertices) {
    const double depth = around.DepthOf(X * vertex);
    if (depth > 0 && depth < deepest) depths->push_back(depth);
  }
}

}  // namespace

std::optional<double> NoiseLevel::deviation() const {
  if (!repeatability || !overlap) return repeatability ? repeatability : overlap;
  return std::max(*repeatability, *overlap);
}

NoiseLevel MeasureNoise(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                        const ProximitySolid& fixed) {
  NoiseLevel level;
  level.repeatability = Repeatability(recording, fixed.solid());
  const double deepest = kDeepest * std::min(SmallestExtent(moving.solid()), SmallestExtent(fixed.solid()));
  std::vector<double> depths;
  for (const input::RecordedScene& scene : recording.scenes) {
    AddDepths(moving, fixed, scene.X_FM, deepest, &depths);
    AddDepths(fixed, moving, scene.X_FM.Inverse(), deepest, &depths);
  }
  level.overlaps = depths.size();
  if (depths.size() >= kLeastOverlaps) level.overlap = Median(std::move(depths)) / kMedianOfHalfNormal;
  return level;
}

}  // namespace tact::recognition

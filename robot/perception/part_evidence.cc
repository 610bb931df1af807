#include "robot/perception/part_evidence.h"

#include <algorithm>
#include <cmath>

#include "robot/perception/alignment.h"

namespace tact::perception {

std::vector<double> CostOf(const Surface& source, const Surface& target, const joint::Transform& X_TS,
                           double deviation) {
  const double gate = kGateOverSpacing * target.spacing;
  std::vector<double> costs;
  costs.reserve(source.points.size());
  for (std::size_t i = 0; i < source.points.size(); ++i) {
    const Eigen::Vector3d at = X_TS * source.points[i];
    const auto near = target.tree.Nearest(at, gate);
    double cost = kMostCost;
    if (near) {
      const Eigen::Vector3d& normal = target.normals[near->index];
      const double deviations = normal.dot(at - target.points[near->index]) / deviation;
      if (std::abs(normal.dot(X_TS.R * source.normals[i])) >= kAlikeCosine)
        cost = std::clamp(deviations * deviations - kExplainedByNoise, 0.0, kMostCost);
    }
    costs.push_back(cost);
  }
  return costs;
}

std::vector<double> MeanField(const Surface& surface, const std::vector<double>& evidence) {
  constexpr int kSweeps = 30;
  constexpr double kOfEach = kCoupling / (kNeighbours - 1);
  std::vector<double> field(evidence.size(), 0), next(evidence.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      double sum = -field[i];  // the first neighbour is the point itself
      for (const std::uint32_t j : surface.neighbours[i]) sum += field[j];
      next[i] = std::tanh(std::clamp(evidence[i], -kMostEvidence, kMostEvidence) + kOfEach * sum);
    }
    field.swap(next);
  }
  return field;
}

std::vector<Part> PartsBy(const std::vector<double>& mean_field) {
  std::vector<Part> parts;
  parts.reserve(mean_field.size());
  for (const double m : mean_field) {
    parts.push_back(std::abs(m) < kDecided ? Part::kUndecided : m > 0 ? Part::kFirst : Part::kSecond);
  }
  return parts;
}

}  // namespace tact::perception

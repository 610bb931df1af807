#include "robot/perception/alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/error.h"
#include "robot/joint/small_matrix.h"

namespace tact::perception {
namespace {

using Eigen::Vector3d;
using joint::Transform;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kNarrowing = 0.75;  // of the gate, each step
constexpr double kTukey = 4.685;     // deviations: 95 % efficient for Gaussian noise
constexpr double kDeviationOfMedian = 1.4826;
constexpr double kStill = 1e-4;             // spacings: a step that moves no point farther is the last
constexpr double kSmallestResidual = 1e-9;  // spacings: scans without noise stay solvable
constexpr std::size_t kFewestPairs = 12;    // twice the unknowns

struct Pair {
  Vector3d at;      // the source point, moved
  Vector3d normal;  // of the target
  double distance;  // from the target point's plane
  double weight;    // by the gate
};

std::vector<Pair> PairsOf(const Surface& source, const Surface& target, const Transform& X_TS, double gate) {
  std::vector<Pair> pairs;
  pairs.reserve(source.points.size());
  for (std::size_t i = 0; i < source.points.size(); ++i) {
    const Vector3d at = X_TS * source.points[i];
    const auto near = target.tree.Nearest(at, gate);
    if (!near) continue;
    const Vector3d& normal = target.normals[near->index];
    if (std::abs(normal.dot(X_TS.R * source.normals[i])) < kAlikeCosine) continue;
    const double slack = 1 - near->squared_distance / (gate * gate);
    pairs.push_back({at, normal, normal.dot(at - target.points[near->index]), slack * slack});
  }
  return pairs;
}

double RobustDeviation(const std::vector<Pair>& pairs) {
  std::vector<double> sizes;
  sizes.reserve(pairs.size());
  for (const Pair& pair : pairs) sizes.push_back(std::abs(pair.distance));
  const auto median = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), median, sizes.end());
  return kDeviationOfMedian * *median;
}

Vector3d Centroid(const Surface& surface) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& p : surface.points) sum += p;
  return sum / static_cast<double>(surface.points.size());
}

Eigen::Matrix3d SpreadAbout(const Vector3d& middle, const Surface& surface) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : surface.points) spread.noalias() += (p - middle) * (p - middle).transpose();
  return spread / static_cast<double>(surface.points.size());
}

// The small motion [w; v] about `middle` that the pairs ask for.
Vector6 Step(const std::vector<Pair>& pairs, const Vector3d& middle, double deviation) {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  for (const Pair& pair : pairs) {
    const double size = pair.distance / (kTukey * deviation);
    if (std::abs(size) >= 1) continue;
    const double slack = 1 - size * size, weight = pair.weight * slack * slack;
    Vector6 row;
    row << (pair.at - middle).cross(pair.normal), pair.normal;
    normal.noalias() += weight * row * row.transpose();
    right.noalias() -= weight * pair.distance * row;
  }
  return joint::SolveSymmetric(normal, right, 1e-9);
}

Matrix6 UnitCovariance(const std::vector<Pair>& pairs, const Transform& X_TS, const Vector3d& centroid_S) {
  Matrix6 information = Matrix6::Zero();
  const Transform X_ST = X_TS.Inverse();
  for (const Pair& pair : pairs) {
    const Vector3d normal_S = X_ST.R * pair.normal;
    Vector6 row;
    row << (X_ST * pair.at - centroid_S).cross(normal_S), normal_S;
    information.noalias() += row * row.transpose();
  }
  // From about the centroid to about the origin: v - w x c.
  Matrix6 shift = Matrix6::Identity();
  const Vector3d& c = centroid_S;
  shift.bottomLeftCorner<3, 3>() << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  return shift * Matrix6(joint::PseudoInverse(information)) * shift.transpose();
}

}  // namespace

Alignment Align(const Surface& source, const Surface& target, const Transform& start,
                const AlignmentOptions& options) {
  if (source.points.empty() || target.points.empty())
    throw PreconditionError("expected points to align, got none");
  const double last_gate = options.last_gate > 0 ? options.last_gate : kGateOverSpacing * target.spacing;
  double gate = std::max(options.first_gate, last_gate);
  const Vector3d centroid_S = Centroid(source);
  const double radius = std::sqrt(SpreadAbout(centroid_S, source).trace());
  Alignment found;
  found.X_TS = start;
  std::vector<Pair> pairs;
  while (found.steps < options.most_steps && !found.converged) {
    ++found.steps;
    pairs = PairsOf(source, target, found.X_TS, gate);
    if (pairs.size() < kFewestPairs) break;
    // While the gate is wide, the distances say how far the start is off, not how good the scans are.
    const double deviation = std::max(RobustDeviation(pairs),
                                      gate > last_gate ? gate / kTukey : kSmallestResidual * target.spacing);
    const Vector3d middle = found.X_TS * centroid_S;
    const Vector6 step = Step(pairs, middle, deviation);
    const Eigen::Matrix3d turn = joint::RotationExp(step.head<3>());
    found.X_TS = {turn * found.X_TS.R, middle + step.tail<3>() + turn * (found.X_TS.p - middle)};
    found.converged =
        gate <= last_gate && radius * step.head<3>().norm() + step.tail<3>().norm() < kStill * target.spacing;
    gate = std::max(last_gate, kNarrowing * gate);
  }
  pairs = PairsOf(source, target, found.X_TS, last_gate);
  found.inliers = static_cast<double>(pairs.size()) / static_cast<double>(source.points.size());
  found.residual = pairs.empty() ? 0 : RobustDeviation(pairs);
  if (pairs.size() >= kFewestPairs) found.unit_covariance = UnitCovariance(pairs, found.X_TS, centroid_S);
  found.converged = found.converged && pairs.size() >= kFewestPairs;
  return found;
}

Alignment FindAlignment(const Surface& source, const Surface& target) {
  constexpr std::size_t kFewPoints = 300;
  constexpr double kWidest = 0.63, kBetween = 0.21;  // 36 and 12 degrees
  const Surface few = Select(source, EvenlySpread(source.points.size(), kFewPoints));
  const Vector3d from = Centroid(few), to = Centroid(target);
  const joint::SymmetricEigen3 shape = joint::EigenOf(SpreadAbout(from, few));
  AlignmentOptions coarse;
  coarse.first_gate = std::sqrt(shape.values.sum()) / 3;
  coarse.last_gate = 1.5 * kGateOverSpacing * target.spacing;
  coarse.most_steps = 25;
  Alignment best;
  best.inliers = -1;
  for (double angle = -kWidest; angle <= kWidest + kBetween / 2; angle += kBetween) {
    const Eigen::Matrix3d R = joint::RotationExp(angle * shape.vectors.col(0));
    const Alignment tried = Align(few, target, {R, to - R * from}, coarse);
    if (tried.inliers > best.inliers) best = tried;
  }
  AlignmentOptions fine;
  fine.first_gate = coarse.last_gate;
  return Align(source, target, best.X_TS, fine);
}

}  // namespace tact::perception

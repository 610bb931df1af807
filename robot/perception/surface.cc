#include "robot/perception/surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "algebra/error.h"
#include "robot/joint/small_matrix.h"

namespace tact::perception {
namespace {

struct Plane {
  Eigen::Vector3d middle, normal;
};

Plane PlaneThrough(std::span<const Eigen::Vector3d> points,
                   const std::array<std::uint32_t, kNeighbours>& which) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : which) middle += points[i];
  middle /= static_cast<double>(kNeighbours);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : which)
    spread.noalias() += (points[i] - middle) * (points[i] - middle).transpose();
  return {middle, joint::EigenOf(spread).vectors.col(0)};
}

double Median(std::vector<double> values) {
  const auto median = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), median, values.end());
  return *median;
}

}  // namespace

Surface SurfaceOf(std::span<const Eigen::Vector3d> points) {
  if (points.size() < kFewestPoints)
    throw PreconditionError("expected a scan of at least " + std::to_string(kFewestPoints) + " points, got " +
                            std::to_string(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      throw PreconditionError("expected finite coordinates, got others in point " + std::to_string(i + 1));
  }
  const NearestPoints measured(points);
  Surface surface;
  surface.points.reserve(points.size());
  surface.normals.reserve(points.size());
  surface.neighbours.reserve(points.size());
  std::vector<double> gaps, moves;
  for (const Eigen::Vector3d& point : points) {
    const std::vector<NearPoint> near = measured.Nearest(point, kNeighbours);
    std::array<std::uint32_t, kNeighbours> which{};
    for (std::size_t k = 0; k < kNeighbours; ++k) which[k] = near[k].index;
    const Plane plane = PlaneThrough(points, which);
    const double move = plane.normal.dot(point - plane.middle);
    surface.points.push_back(point - move * plane.normal);
    surface.normals.push_back(plane.normal);
    surface.neighbours.push_back(which);
    gaps.push_back(near[1].squared_distance);
    moves.push_back(std::abs(move));
  }
  surface.spacing = std::sqrt(Median(gaps));
  // A plane has three parameters: it follows that share of the noise.
  constexpr double kDeviationOfMedian = 1.4826, kLeft = 1 - 3.0 / kNeighbours;
  surface.noise = kDeviationOfMedian * Median(moves) / std::sqrt(kLeft);
  surface.tree = NearestPoints(surface.points);
  return surface;
}

Surface Select(const Surface& surface, std::span<const std::uint32_t> which) {
  Surface part;
  part.points.reserve(which.size());
  part.normals.reserve(which.size());
  for (const std::uint32_t i : which) {
    part.points.push_back(surface.points[i]);
    part.normals.push_back(surface.normals[i]);
  }
  part.spacing = surface.spacing;
  part.noise = surface.noise;
  part.tree = NearestPoints(part.points);
  return part;
}

std::vector<std::uint32_t> EvenlySpread(std::size_t n, std::size_t count) {
  std::vector<std::uint32_t> which;
  const std::size_t taken = std::min(n, count);
  which.reserve(taken);
  for (std::size_t i = 0; i < taken; ++i) which.push_back(static_cast<std::uint32_t>(i * n / taken));
  return which;
}

}  // namespace tact::perception

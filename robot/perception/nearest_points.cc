#include "robot/perception/nearest_points.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tact::perception {
namespace {

constexpr std::size_t kFew = 8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

NearestPoints::NearestPoints(std::span<const Eigen::Vector3d> points)
    : points_(points.begin(), points.end()), indices_(points.size()), axes_(points.size(), 0) {
  std::iota(indices_.begin(), indices_.end(), 0U);
  Build(0, points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) points_[i] = points[indices_[i]];
}

void NearestPoints::Build(std::size_t begin, std::size_t end) {
  if (end - begin <= kFew) return;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(kInfinity), high = -low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(points_[indices_[i]]);
    high = high.cwiseMax(points_[indices_[i]]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return indices_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
  });
  axes_[middle] = static_cast<std::uint8_t>(axis);
  Build(begin, middle);
  Build(middle + 1, end);
}

// offer(point) takes a point or not and returns the squared distance that still interests.
template <typename Offer>
void NearestPoints::Search(std::size_t begin, std::size_t end, const Eigen::Vector3d& place,
                           const Offer& offer) const {
  const auto look = [&](std::size_t i) {
    return offer(NearPoint{(points_[i] - place).squaredNorm(), indices_[i]});
  };
  if (end - begin <= kFew) {
    for (std::size_t i = begin; i < end; ++i) look(i);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const double beyond = place[axes_[middle]] - points_[middle][axes_[middle]];
  beyond < 0 ? Search(begin, middle, place, offer) : Search(middle + 1, end, place, offer);
  if (beyond * beyond > look(middle)) return;
  beyond < 0 ? Search(middle + 1, end, place, offer) : Search(begin, middle, place, offer);
}

std::optional<NearPoint> NearestPoints::Nearest(const Eigen::Vector3d& place, double reach) const {
  NearPoint best{reach * reach, std::numeric_limits<std::uint32_t>::max()};
  Search(0, points_.size(), place, [&](const NearPoint& point) {
    best = std::min(best, point);
    return best.squared_distance;
  });
  if (best.index == std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return best;
}

std::vector<NearPoint> NearestPoints::Nearest(const Eigen::Vector3d& place, std::size_t count) const {
  std::vector<NearPoint> heap;  // the farthest first
  heap.reserve(count + 1);
  if (count == 0) return heap;
  Search(0, points_.size(), place, [&](const NearPoint& point) {
    if (heap.size() < count || point < heap.front()) {
      heap.push_back(point);
      std::push_heap(heap.begin(), heap.end());
      if (heap.size() > count) {
        std::pop_heap(heap.begin(), heap.end());
        heap.pop_back();
      }
    }
    return heap.size() < count ? kInfinity : heap.front().squared_distance;
  });
  std::sort_heap(heap.begin(), heap.end());
  return heap;
}

}  // namespace tact::perception

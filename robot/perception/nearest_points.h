/// @file
/// The points nearest to a place: a k-d tree, balanced, without pointers.
/// Exact   ties go to the point of the lower index, so that the answer does not depend on the tree.
/// Cost    O(n log n) to build, about O(log n) a question.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tact::perception {

struct NearPoint {
  double squared_distance = 0;
  std::uint32_t index = 0;  // into the points that the tree was built of

  auto operator<=>(const NearPoint&) const = default;
};

class NearestPoints {
 public:
  NearestPoints() = default;
  /// Pre: finite points, fewer than 2^32.
  explicit NearestPoints(std::span<const Eigen::Vector3d> points);

  /// The nearest point at a distance of at most `reach`.
  std::optional<NearPoint> Nearest(const Eigen::Vector3d& place, double reach) const;

  /// The nearest points, at most `count` of them, nearest first.
  std::vector<NearPoint> Nearest(const Eigen::Vector3d& place, std::size_t count) const;

 private:
  void Build(std::size_t begin, std::size_t end);
  template <typename Offer>
  void Search(std::size_t begin, std::size_t end, const Eigen::Vector3d& place, const Offer& offer) const;

  // A range's middle splits it along axes_[middle]; ranges of few points are not split.
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint8_t> axes_;
};

}  // namespace tact::perception

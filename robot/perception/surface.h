/// @file
/// A scanned surface: points, and through each the plane that its neighbours lie in.
/// Model   the plane of least squares through a point and its nearest neighbours; the point is moved onto it, which averages
///         the scanner's noise. Both follow the points when these are moved, whatever the frame.
/// Units   those of the points.
/// Exact   no. A normal's sign is open.
/// Errors  PreconditionError: fewer than kFewestPoints points, or one that is not finite.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot/perception/nearest_points.h"

namespace tact::perception {

inline constexpr std::size_t kNeighbours = 16;  // with the point itself: half of them lie within two pixels
inline constexpr std::size_t kFewestPoints = 50;

struct Surface {
  std::vector<Eigen::Vector3d> points, normals;
  std::vector<std::array<std::uint32_t, kNeighbours>> neighbours;  // of each point, nearest (itself) first
  double spacing = 0;  // the median distance to the nearest other point
  double noise = 0;    // standard deviation of the points before they were moved, across their planes
  NearestPoints tree;
};

Surface SurfaceOf(std::span<const Eigen::Vector3d> points);

/// Points of a surface, their planes kept; without neighbours.
Surface Select(const Surface& surface, std::span<const std::uint32_t> which);

/// At most `count` of n numbers from 0, evenly spread.
std::vector<std::uint32_t> EvenlySpread(std::size_t n, std::size_t count);

}  // namespace tact::perception

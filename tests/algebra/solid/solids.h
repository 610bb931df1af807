/// @file
/// Small soups for tests: boxes, prisms, a box with a hole, and soups put together.
#pragma once

#include <initializer_list>
#include <string>

#include "algebra/error.h"
#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

/// The six outward quads of the box from low to high.
inline PolygonSoup Box(const Vector3& low, const Vector3& high) {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) {
    soup.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  soup.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return soup;
}

/// The prism over a counter-clockwise outline, from z = low to high.
inline PolygonSoup Prism(const std::vector<std::pair<Rational, Rational>>& outline, const Rational& low,
                         const Rational& high) {
  PolygonSoup soup;
  const size_t n = outline.size();
  for (const auto& [x, y] : outline) soup.points.push_back({x, y, low});
  for (const auto& [x, y] : outline) soup.points.push_back({x, y, high});
  soup.polygons.resize(2);
  for (size_t i = 0; i < n; ++i) {
    soup.polygons[0].push_back(n - 1 - i);
    soup.polygons[1].push_back(n + i);
    soup.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return soup;
}

/// A 6 x 6 x 2 plate with a 2 x 2 hole through it; top and bottom are four trapezoids each.
inline PolygonSoup PlateWithHole() {
  PolygonSoup soup;
  for (const int z : {0, 2}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {4, 4}, {2, 4}}) {
      soup.points.push_back({x, y, z});
    }
  }
  for (size_t i = 0; i < 4; ++i) {
    const size_t j = (i + 1) % 4;
    soup.polygons.push_back({8 + i, 8 + j, 12 + j, 12 + i});  // top
    soup.polygons.push_back({4 + i, 4 + j, j, i});            // bottom
    soup.polygons.push_back({i, j, 8 + j, 8 + i});            // outside
    soup.polygons.push_back({12 + i, 12 + j, 4 + j, 4 + i});  // hole
  }
  return soup;
}

inline PolygonSoup Reversed(PolygonSoup soup) {
  for (auto& polygon : soup.polygons) polygon = {polygon.rbegin(), polygon.rend()};
  return soup;
}

/// Both, each with points of its own.
inline PolygonSoup operator+(PolygonSoup a, const PolygonSoup& b) {
  const size_t shift = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (auto polygon : b.polygons) {
    for (size_t& corner : polygon) corner += shift;
    a.polygons.push_back(std::move(polygon));
  }
  return a;
}

/// Every polygon fanned into triangles from its first corner; right for convex polygons.
inline PolygonSoup Triangulated(const PolygonSoup& soup) {
  PolygonSoup result{soup.points, {}};
  for (const auto& polygon : soup.polygons) {
    for (size_t i = 2; i < polygon.size(); ++i) {
      result.polygons.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
  }
  return result;
}

inline PolygonSoup Moved(PolygonSoup soup, const Vector3& by) {
  for (Vector3& point : soup.points) point = point + by;
  return soup;
}

/// Why a soup is refused; empty if it is not.
inline std::string Refusal(const PolygonSoup& soup, size_t* polygon = nullptr) {
  try {
    BuildPolyhedron(soup);
  } catch (const SoupError& error) {
    if (polygon != nullptr) *polygon = error.defect().polygon;
    return error.defect().what;
  }
  return "";
}

}  // namespace tact::algebra

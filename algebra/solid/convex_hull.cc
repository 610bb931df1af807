#include "algebra/solid/convex_hull.h"

#include <algorithm>

#include "algebra/cone/cone.h"
#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"
#include "algebra/solid/planar_region.h"

namespace tact::algebra {
namespace {

// A row (a, b) says that a . p + b >= 0 on the hull.
HalfspaceCone FacetsOver(const std::vector<Vector3>& points) {
  std::vector<std::vector<Rational>> rays;
  for (const Vector3& p : points) rays.push_back({p.x, p.y, p.z, 1});
  return Facets({IntegerMatrix(0, 4), IntegerMatrix::FromRationalRows(rays, 4)});
}

Vector3 InwardNormal(const IntegerMatrix& facets, size_t i) {
  return {facets(i, 0), facets(i, 1), facets(i, 2)};
}

std::vector<size_t> FacetsAt(const IntegerMatrix& facets, const Vector3& p) {
  std::vector<size_t> tight;
  for (size_t i = 0; i < facets.rows; ++i) {
    if ((Dot(InwardNormal(facets, i), p) + Rational(facets(i, 3))).sign() == 0) tight.push_back(i);
  }
  return tight;
}

}  // namespace

PolygonSoup ConvexHull(const std::vector<Vector3>& points) {
  const HalfspaceCone cone = FacetsOver(points);
  if (cone.equalities.rows > 0) {
    throw PreconditionError("ConvexHull: expected points that are not all in one plane, got " +
                            std::to_string(points.size()) + " in one");
  }
  const IntegerMatrix& facets = cone.inequalities;
  PolygonSoup hull;
  hull.polygons.resize(facets.rows);
  for (const Vector3& p : points) {
    const std::vector<size_t> tight = FacetsAt(facets, p);
    // Three facets through p that no other point shares: their rows, with heights, have rank 3.
    if (RankOfRows(facets, tight) < 3 || std::ranges::find(hull.points, p) != hull.points.end()) continue;
    for (const size_t i : tight) hull.polygons[i].push_back(hull.points.size());
    hull.points.push_back(p);
  }
  for (size_t i = 0; i < facets.rows; ++i) {
    std::vector<size_t>& polygon = hull.polygons[i];
    const Axes axes = ProjectionAxes(-InwardNormal(facets, i));
    // Seen from a corner, the others of a convex polygon lie within less than half a turn.
    const Vector3& pivot = hull.points[polygon.front()];
    std::sort(polygon.begin() + 1, polygon.end(), [&](size_t a, size_t b) {
      return Orientation(axes, pivot, hull.points[a], hull.points[b]) > 0;
    });
  }
  return hull;
}

}  // namespace tact::algebra

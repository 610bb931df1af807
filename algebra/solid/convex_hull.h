/// @file
/// Convex hulls of points in space.
/// Model   The facets are those of the cone over the points at height one (cone.h).
/// Exact   every decision; coplanar and repeated points are no special case.
/// Cost    that of the cone's facets: milliseconds for 40 points.
#pragma once

#include <vector>

#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

/// The hull's surface: one polygon a face, counter-clockwise seen from outside, beginning with its first
/// corner. The points are the hull's corners, each once, in the order given; the polygons' order depends on
/// the hull alone. PreconditionError: the points are all in one plane.
PolygonSoup ConvexHull(const std::vector<Vector3>& points);

}  // namespace tact::algebra

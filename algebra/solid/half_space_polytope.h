/// @file
/// Polytopes given by half-spaces.
/// Model   { x | n . x <= offset for all half-spaces }, by the generators of the cone over it (cone.h).
/// Exact   every decision; redundant and repeated half-spaces are no special case.
#pragma once

#include <utility>
#include <vector>

#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

/// The polytope's surface as ConvexHull gives it; the order of points depends on the polytope alone.
/// PreconditionError: a zero normal, or a set that is empty, unbounded or flat; the message says which.
PolygonSoup HalfSpacePolytope(const std::vector<std::pair<Vector3 /*n*/, Rational /*offset*/>>& half_spaces);

}  // namespace tact::algebra

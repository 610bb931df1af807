/// @file
/// A planar face with holes cut into triangles: a polygon soup has no holes.
/// Model   CGAL's constrained Delaunay triangulation. The triangles' corners are the loops' corners, none is added.
/// Exact   rational coordinates; no tolerance anywhere.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "algebra/screw/vector3.h"

namespace tact::cad {

/// Indices into points, counter-clockwise about the normal. loops[0] is the outer one, counter-clockwise, the others are
/// holes, clockwise; all in one plane. nullopt for loops that cross or touch, or a hole outside.
std::optional<std::vector<std::array<size_t, 3>>> CutFace(const std::vector<algebra::Vector3>& points,
                                                          const std::vector<std::vector<size_t>>& loops,
                                                          const algebra::Vector3& normal);

}  // namespace tact::cad

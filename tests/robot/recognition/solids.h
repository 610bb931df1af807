/// @file
/// Small solids for tests.
#pragma once

#include "algebra/solid/polyhedron.h"

namespace tact::recognition {

/// The box [-x, x] x [-y, y] x [-z, z].
inline algebra::Polyhedron Box(const algebra::Rational& x, const algebra::Rational& y,
                               const algebra::Rational& z) {
  algebra::PolygonSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.push_back({(i & 1) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 4) != 0 ? z : -z});
  soup.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return algebra::BuildPolyhedron(soup);
}

}  // namespace tact::recognition

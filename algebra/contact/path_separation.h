/// @file
/// Planes that keep two convex pieces apart while one of them moves along a path.
/// Model   From one s to another a plane through a corner: with a fixed facet's normal, with a moving facet's,
///         carried along, or at a right angle to a carried edge and a fixed edge. All heights of corners over it
///         are quadratic in s (path_polynomial.h); each is zero or has one sign throughout. Where no such plane
///         lasts, the interval is halved.
/// Exact   every sign.
/// Errors  BudgetError: none found after kMostHalvings halvings.
#pragma once

#include <array>
#include <vector>

#include "algebra/contact/motion_path.h"

namespace tact::algebra {

struct PathPlane {
  enum class Kind { kFixed, kCarried, kEdges };
  Kind kind = Kind::kFixed;
  Rational until;     // from where the plane before ends, not included itself
  size_t corner = 0;  // of the fixed piece; of the moving one if carried
  Vector3 normal;     // to the moving piece's side; in the moving frame if carried
  std::array<size_t, 2> moving_edge{}, fixed_edge{};  // of kEdges: their cross product is the normal
};

/// Corners are those of the pieces' hulls (convex_hull.h), none left out. From 0 to 1; the pieces must not
/// overlap on the way.
std::vector<PathPlane> SeparateAlong(const PolygonSoup& moving_hull, const PolygonSoup& fixed_hull,
                                     const MotionPath& path);

}  // namespace tact::algebra

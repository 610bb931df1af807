/// @file
/// A motion of one solid past another: solids as unions of convex pieces, and the path.
/// Model   A piece is the convex hull of its corners. Pieces of one solid may touch but not overlap.
/// Frames  the moving pieces stand where the path has them at s = 0.
/// Errors  PreconditionError: a solid without pieces, a flat piece, pieces of one solid that overlap.
#pragma once

#include <vector>

#include "algebra/contact/motion_path.h"

namespace tact::algebra {

struct Scene {
  std::vector<std::vector<Vector3>> moving_pieces, fixed_pieces;  // corners
  MotionPath path;
};

/// The union of the hulls, a shell a piece, in order.
Polyhedron UnionOfHulls(const std::vector<std::vector<Vector3>>& pieces);
/// FollowPath of the two unions.
PathContacts FollowScene(const Scene& scene);

}  // namespace tact::algebra

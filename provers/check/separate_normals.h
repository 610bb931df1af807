/// @file
/// The separate planes of two convex pieces that touch at a point.
/// Model   The normals n with n . (m - p) >= 0 for the moving corners m and n . (f - p) <= 0 for the fixed ones
///         are a cone; the separate planes are its extreme rays. Each is at a right angle to two independent of
///         these differences, so all pairs are tried.
/// Exact   integers, + * = < only.
#pragma once

#include "provers/check/touching.h"

namespace tact::check {

bool SameDirection(const Row& a, const Row& b);
/// Whether each direction of one list is in the other.
bool Includes(const Matrix& larger, const Matrix& smaller);

/// The extreme rays of { n | n . g >= 0 for each g }, each once, if the g span all of space.
Matrix ExtremeNormals(const Matrix& generators);

/// The pieces are in place; precondition: neither is flat.
Matrix SeparateNormals(const Piece& moving, const Piece& fixed, const Row& point);

}  // namespace tact::check

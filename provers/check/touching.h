/// @file
/// Where two convex polygons in one plane touch while one of them moves: the corners of what they share.
/// Model   A moving corner in the fixed polygon, a fixed corner in the moving one, a crossing of two edges' inner
///         points. Two convex polygons that share a point share such a corner. A polygon may be a segment or a
///         point.
/// Exact   each decision holds all over a stage (path_geometry.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "provers/check/path_geometry.h"

namespace tact::check {

/// The corners of a convex piece, each [X, Y, Z, W].
using Piece = std::vector<Row>;

/// Which corner: those of the moving piece and of the fixed piece that make it, one or two each or none.
struct TouchingCorner {
  std::vector<std::size_t> moving, fixed;
  PolynomialPoint point;

  friend bool operator<(const TouchingCorner& a, const TouchingCorner& b) {
    return a.moving != b.moving ? a.moving < b.moving : a.fixed < b.fixed;
  }
  friend bool operator==(const TouchingCorner& a, const TouchingCorner& b) {
    return a.moving == b.moving && a.fixed == b.fixed;
  }
};

/// A moving and a fixed piece with the corners of each that lie in a plane between them, and its normal.
struct PlanePair {
  const Piece& moving;
  const Piece& fixed;
  std::vector<std::size_t> moving_corners, fixed_corners;
  PolynomialVector normal;
};

/// The corners in ascending order, none if the polygons stay apart; or which touch comes or goes during the
/// stage, as far as signs that last all the stage can tell.
struct TouchingAnswer {
  std::vector<TouchingCorner> corners;
  std::string undecided;
};
TouchingAnswer TouchingCorners(const PlanePair& pair, const Path& path, const Stage& stage);

}  // namespace tact::check

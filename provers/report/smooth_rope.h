/// @file
/// A rope's layout as a smooth curve: a cubic between neighbouring nodes, with a tangent of its own at every node.
#pragma once

#include <array>
#include <vector>

#include "algebra/knot/curve_projection.h"
#include "provers/report/rope_layout.h"

namespace tact::provers {

/// A Bezier curve of degree three.
struct Cubic {
  std::array<LayoutPoint, 4> control;

  LayoutPoint At(double share) const;
  /// The part between two shares.
  Cubic Part(double from, double to) const;
  /// Of the chord.
  double length() const;
};

/// Cubic k leads from node k of the rope to node k + 1. At node k the handles are `bends[k]` thirds of the edges: 1 round, 0 straight.
std::vector<Cubic> SmoothRope(const RopeLayout& layout, const std::vector<double>& bends);

/// The cubics as a polyline on a grid of integers, z > 0 where the rope passes over at an intersection and < 0 where under: for
/// ProjectCurve from above. Intersections are met inside edges. Point i of it, from 1, is on cubic CubicOf(i).
knot::Curve PolylineOf(const std::vector<Cubic>& cubics, const RopeLayout& layout, const knot::PData& p);

size_t CubicOf(int point, size_t cubics);

}  // namespace tact::provers

/// @file
/// The painter's order: flat faces from back to front, so that each covers what lies behind it.
/// Model   Of two faces whose pictures overlap, depths are compared where their corners and edges meet; faces that touch are
///         ordered by the way they face. A topological sort follows; cycles, which only interlocked faces make, are cut at
///         the face farthest back.
/// Cost    O(n^2) pairs of faces, of which those with disjoint boxes cost nothing.
#pragma once

#include <cstddef>
#include <vector>

#include "provers/report/projection.h"

namespace tact::provers {

/// A face in view coordinates: loops[0] is its outside, the others are holes.
struct FlatFace {
  std::vector<std::vector<ViewPoint>> loops;
  ViewPoint normal;  // outward, unit length; z is not zero
};

/// The face's z above or below (x, y), on its plane.
double DepthAt(const FlatFace& face, double x, double y);

/// Whether (x, y) lies in the face's picture, border included within `margin`.
bool Covers(const FlatFace& face, double x, double y, double margin);

/// Indices of the faces from back to front. Depths that differ by less than `margin` count as touching.
std::vector<size_t> PaintOrder(const std::vector<FlatFace>& faces, double margin);

}  // namespace tact::provers

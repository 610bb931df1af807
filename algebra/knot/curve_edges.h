/// @file
/// Two edges of a rope curve as a viewer sees them: how their shadows meet and which is the upper one.
/// Model   A point's shadow has coordinates right and up, its height grows toward the viewer; (right, up, height) is a linear
///         map of the point that keeps handedness. Angles and lengths it does not keep, and signs do not need them.
/// Exact   integers: points are scaled to their common denominator.
#pragma once

#include <algorithm>
#include <vector>

#include "algebra/exact/rational.h"
#include "algebra/screw/vector3.h"

namespace tact::knot {

struct SeenPoint {
  algebra::Integer right, up, height;
};

struct SeenEdge {
  SeenPoint from, to;
  SeenPoint along;  // to - from

  const algebra::Integer& low_right() const { return std::min(from.right, to.right); }
  const algebra::Integer& high_right() const { return std::max(from.right, to.right); }
  const algebra::Integer& low_up() const { return std::min(from.up, to.up); }
  const algebra::Integer& high_up() const { return std::max(from.up, to.up); }
};

/// The edges of a polyline, seen by a viewer in the direction of the view. PreconditionError: a view of length zero.
std::vector<SeenEdge> SeenEdges(const std::vector<algebra::Vector3>& points, const algebra::Vector3& view);

inline bool IsSeenAsPoint(const SeenEdge& edge) {
  return edge.along.right.sign() == 0 && edge.along.up.sign() == 0;
}

enum class EdgeMeeting {
  kNone,
  kCrossing,
  kPointOfFirst,  // an end of the first edge on the second edge, its ends included
  kPointOfSecond,
  kOverlap,
  kInSpace,  // they have a point in common, not only their shadows
};

struct EdgePair {
  EdgeMeeting meeting = EdgeMeeting::kNone;
  int point = 0;                          // kPointOf...: 0 the edge's first point, 1 its last
  algebra::Rational at_first, at_second;  // kCrossing: the place in units of each edge
  bool first_over = false;                // kCrossing
  int turn = 0;                           // kCrossing: sign of (first x second) . view
};

/// Pre: neither edge is seen as a point, and none ends where the other begins.
EdgePair CompareEdges(const SeenEdge& first, const SeenEdge& second);
/// Of edges one of which begins where the other ends: whether the second one leads back over the first.
EdgePair CompareNeighbours(const SeenEdge& first, const SeenEdge& second);

}  // namespace tact::knot

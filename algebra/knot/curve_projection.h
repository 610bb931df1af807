/// @file
/// Rope curves in space to P-data: a knot projection [thesis, 5.1.1] along a direction, or the reason why there is none.
/// Model   A rope is a polyline; edge i goes from point i to point i + 1, the first point is the selective end. It is seen
///         from far away, the view pointing from the rope to the viewer; the view's length means nothing. A knot
///         projection has point intersections of two strands that cross, no three at one place, and no point of the
///         polyline, an end or not, on a strand. Anything else is a fault: it is named, never moved out of the way.
/// Frames  points and view in one right-handed frame.
/// Units   any: P-data do not depend on scale.
/// Exact   rational points; every predicate is the sign of an integer.
/// Errors  PreconditionError: a view of length zero.
/// Cost    O(n log n + pairs of edges whose shadows' intervals meet in one direction).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "algebra/knot/p_data.h"
#include "algebra/screw/vector3.h"

namespace tact::knot {

using Curve = std::vector<algebra::Vector3>;

/// In the order in which they are looked for; of several the first is named, by points.
enum class CurveFaultKind {
  // Of the curve: every view has it.
  kTooFewPoints,
  kRepeatedPoint,  // an edge of length zero
  kClosed,         // the last point is the first one
  kMeetsItself,    // no strand is the upper one
  // Of the view: another one may be without it.
  kVerticalEdge,  // an edge seen as a point
  kOverlap,       // two edges seen on one line, one over a part of the other
  kPointOnEdge,   // a point of the polyline seen on an edge that does not end there
  kTriplePoint,   // three edges seen through one point
  kTooManyIntersections,
};

struct CurveFault {
  CurveFaultKind kind = CurveFaultKind::kTooFewPoints;
  std::vector<int> points;  // from 1; an edge is its two points
  bool of_view() const { return kind >= CurveFaultKind::kVerticalEdge; }
  /// "expected ..., got ...", with the points named.
  std::string what() const;

  friend bool operator==(const CurveFault&, const CurveFault&) = default;
};

/// A place on the curve: point edge plus `at` times edge, 0 < at < 1.
struct CurvePlace {
  int edge = 1;
  algebra::Rational at;

  friend bool operator==(const CurvePlace&, const CurvePlace&) = default;
};

struct CurveProjection {
  PData p;
  std::vector<CurvePlace> places;  // of column i at index i - 1
};

/// Intersections of one projection, at most: what has more is refused as kTooManyIntersections, whatever else is wrong.
inline constexpr int kMostCurveIntersections = 1'000'000;

std::variant<CurveProjection, CurveFault> ProjectCurve(const Curve& curve, const algebra::Vector3& view,
                                                       int most_intersections = kMostCurveIntersections);

}  // namespace tact::knot

/// @file
/// Which view shows rope curves with the fewest intersections, out of a fixed list.
/// Model   CandidateViews: from above, then the directions (+-2, +-3, +-6) and (+-1, +-2, +-2), their numbers in any order, that
///         point up, from steep to flat: every direction is within 32 degrees of one or of its opposite, which shows the
///         same intersections mirrored. Of the views without a fault in any curve the one with the fewest intersections in all
///         curves together is chosen, of equals the first. Curves that are steps of one task need one view: P-data seen
///         from two sides have nothing to do with each other.
/// Exact   rational directions; no curve is moved.
/// Cost    that of projecting every curve from each of the views, of which most are given up when they show too many.
#pragma once

#include <variant>
#include <vector>

#include "algebra/knot/curve_projection.h"

namespace tact::knot {

inline algebra::Vector3 ViewFromAbove() { return {0, 0, 1}; }

std::vector<algebra::Vector3> CandidateViews();

struct ProjectedCurves {
  algebra::Vector3 view;
  std::vector<CurveProjection> projections;  // of each curve
  int views = 1;                             // how many were tried

  int Intersections() const;
};

/// A curve, by index, and what is wrong with it.
struct FaultyCurve {
  size_t index = 0;
  CurveFault fault;
};

/// From one view: the first curve with a fault, if any; more intersections in all curves than so many are one.
std::variant<ProjectedCurves, FaultyCurve> ProjectCurves(const std::vector<Curve>& curves,
                                                         const algebra::Vector3& view,
                                                         int most_intersections = kMostCurveIntersections);
/// From the best view; if there is none, what is wrong from above, or with a curve whatever the view.
std::variant<ProjectedCurves, FaultyCurve> ProjectCurvesFromBestView(const std::vector<Curve>& curves);

}  // namespace tact::knot

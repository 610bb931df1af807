/// @file
/// P-data as a picture of a rope: smooth strands, gaps where they pass under, the selective end a dot, the other an arrowhead.
/// Model   Circles packed over the triangulation of diagram_triangulation.h; in each circle that the rope runs through it is the arc
///         at right angles to the circle between the two points where it touches its neighbours on the rope, so the rope is
///         smooth, and two arcs cross just in the circles of intersections. What is drawn is read back by exact predicates
///         (ProjectCurve on the arcs as polylines); where that is not the P-data, the exact drawing is shown instead.
/// Shapes  an <svg> element of at most `size` pixels a side.
/// Errors  PreconditionError: P-data that no sphere holds; no such outer face.
#pragma once

#include <optional>
#include <string>

#include "algebra/knot/p_data.h"

namespace tact::provers {

struct KnotDrawingOptions {
  std::optional<int> outer;  // the face that is outside, from 0; none: BestOuterFace
  bool exact = false;        // straight edges of the exact drawing
  bool labels = false;       // numbers of segments and of intersections' columns
  double size = 480;
  std::string title;  // none: "A rope with 3 intersections"
};

std::string KnotSvg(const knot::PData& p, const KnotDrawingOptions& options = {});

}  // namespace tact::provers

/// @file
/// P-data to a knot projection with exact coordinates, straight edge by straight edge [thesis, 5.1.4].
/// Model   The triangulation of diagram_triangulation.h, its outer ring on a convex polygon of integers, every other vertex in the mean
///         of its neighbours [Tutte 1963], solved exactly (sparse_solve.h); then rounded to a grid as coarse as leaves every
///         triangle positive. The rope runs along the triangles' edges; at an intersection the lower strand goes round the
///         vertex and through one edge of the upper strand, so that the two cross inside edges.
/// Shapes  the curve is seen from above, from z > 0; lower strands are at z = -1, everything else at z = 0.
/// Exact   the coordinates. ProjectCurve(curve, ViewFromAbove()) is the P-data again.
/// Errors  as TriangulateDiagram; InvariantError: a triangle that is not positive.
/// Cost    that of the sparse system, some 150 vertices at 30 intersections.
#pragma once

#include "algebra/knot/curve_projection.h"
#include "algebra/knot/diagram_triangulation.h"

namespace tact::knot {

struct PlanePoint {
  algebra::Rational x, y;
};

/// Where each vertex lies; every triangle is positive.
std::vector<PlanePoint> EmbedTriangulation(const DiagramTriangulation& triangulation);

/// The rope of P-data drawn, `outer` being the face that is not drawn round.
Curve DrawExactly(const PData& p, int outer = 0);

}  // namespace tact::knot

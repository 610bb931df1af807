/// @file
/// A diagram's faces filled with triangles, so that it can be drawn with straight edges: the thesis' barycentric subdivision
/// [5.1.4], made finer where that is no simple graph.
/// Model   Vertices: the intersections, the rope's ends, a point of each segment (two of a segment that leads from an intersection
///         back to it), and in each face a centre that is joined to all vertices round it. Where the walk round a face comes to
///         a vertex twice, and in the outer face, a ring comes first: a vertex for each edge of the walk, joined to the edge's
///         ends and to its neighbours on the ring; the centre is joined to the ring. The outer face has no centre: its ring is
///         the boundary of what is drawn.
///         Every walk has at least three edges, since each edge is cut. So no two vertices are joined twice and none with itself,
///         for all planar P-data, reducible or not; the ring has no chord. A triangulated disc like this is drawn with each
///         triangle positive by Tutte's method [Tutte 1963; Floater 1997], whatever convex polygon the ring is put on.
/// Errors  PreconditionError: P-data that no sphere holds; no such face.
/// Cost    O(n).
#pragma once

#include <array>
#include <vector>

#include "algebra/knot/faces.h"

namespace tact::knot {

struct DiagramTriangulation {
  int vertices = 0;                           // numbered from 0, those of the boundary last
  std::vector<std::array<int, 3>> triangles;  // counterclockwise
  std::vector<int> boundary;                  // the outer ring, clockwise
  std::vector<int> rope;   // the vertices that the rope runs through, from its selective end
  std::vector<int> place;  // of column i in `rope`, at index i - 1

  bool OnBoundary(int vertex) const { return vertex >= vertices - static_cast<int>(boundary.size()); }
};

/// `outer` is a face of Faces(p), from 0. `more` are points on each segment beyond those of the model, at index segment - 1; none
/// if it is empty.
DiagramTriangulation TriangulateDiagram(const PData& p, int outer = 0, const std::vector<int>& more = {});

/// The face that makes the most even drawing from outside: of those from which every other is reached across the fewest segments, or one
/// more, the one with the longest walk, of equals the first. O(n^2).
int BestOuterFace(const Faces& faces, int segments);

}  // namespace tact::knot

/// @file
/// The graphs of [thesis, 5.1.3], literally: the knot graph, its dual, its barycentric subdivision. On trial in
/// provers/claims/.
/// Model   A vertex of the knot graph is an intersection; vertices are numbered from 0 by their first columns. Its edge
///         e_k, k = 1..n-1, joins the intersections of columns k and k + 1 and is segment k + 1: the first and the last
///         segment are no edges [thesis, Definition 7; 5.4.1 counts so]. Edge e_k stands at [k - 1]. The knot graph of
///         the straight rope is empty.
/// Faces   are those of faces.h: the two segments left out hang into one face each, and part no face.
/// Cost    O(n).
#pragma once

#include <vector>

#include "algebra/knot/graph.h"
#include "algebra/knot/p_data.h"

namespace tact::knot {

/// For each column from 1 its intersection's vertex. Index 0 is not used.
std::vector<int> VerticesOfColumns(const PData& p);
Graph KnotGraph(const PData& p);
/// How many edges the knot graph has at each vertex, a loop counted twice.
std::vector<int> Degrees(const Graph& graph);

/// A face's edges e_k as k, in the order of its walk; an edge with the face on both sides stands there twice.
using EdgeWalk = std::vector<int>;
/// Of each face on the surface that p fills, in the order of faces.h.
std::vector<EdgeWalk> KnotGraphFaces(const PData& p);

/// A vertex for each face but the external one, an edge for each edge between two such faces. External from 0; none:
/// -1.
Graph DualGraph(const PData& p, int external);
/// Each edge halved by a vertex, numbered from crossings() on, and a vertex for each face but the external one, joined
/// to all vertices on the face's boundary. An edge's middle counts to the boundary.
Graph BarycentricSubdivision(const PData& p, int external);

}  // namespace tact::knot

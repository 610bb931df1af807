/// @file
/// The search for faces of [thesis, 5.1.3], literally: shorter loops of the knot graph first, each edge in two of them,
/// and the caution about loops that follow one strand. On trial in provers/claims/; faces.h traces faces instead.
/// Model   A loop is a set of edges of thesis_graphs.h, bit k - 1 for e_k, that form a simple closed path. A choice
///         that the text leaves open, which of several shortest loops comes first, is made in every way.
/// Errors  PreconditionError: more than 32 edges.
/// Cost    exponential; loops are listed one by one.
#pragma once

#include <cstdint>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot::thesis {

using EdgeSet = uint32_t;

/// "Consider the vertex which has four adjacent edges ... i-th and j-th intersections. At this time, these edges are
/// i-1-th, i-th, j-1-th, and j-th segments. Loops including i-1-th and i-th segments do not compose a face", nor those
/// with j.
enum class Caution {
  kNone,
  kEdges,        // edges counted as in 5.4.1: e_(i-1) and e_i, at vertices of four edges
  kSegments,     // segments counted as in Definition 2: e_(i-2) and e_(i-1), at vertices of four edges
  kEveryVertex,  // e_(i-1) and e_i, wherever both are there
};
enum class LoopOrder {
  kShortestFirst,  // of all loops still allowed
  kEdgeByEdge,     // of those through the first edge that is not in two faces yet
  kCornerByCorner  // of those through the first two edges of one vertex, allowed together, that no face has both of
};
struct FaceSearchReading {
  Caution caution = Caution::kEdges;
  LoopOrder order = LoopOrder::kShortestFirst;
};

/// Whether the caution allows the loop to be a face.
bool Allows(const PData& p, Caution caution, EdgeSet loop);
/// The loops that the caution allows, shortest first, then by number.
std::vector<EdgeSet> FindLoops(const PData& p, Caution caution);

/// Where the choices lead.
struct FaceSearchOutcome {
  bool right = false;  // some choices give the faces of p
  bool wrong = false;  // some do not
  std::vector<EdgeSet>
      chosen;          // if wrong: faces, and last the first loop that is none, unless the search gets stuck
  bool stuck = false;  // if wrong: no loop is left though an edge is not in two faces
};
/// Precondition: p is of a sphere, irreducible, with two intersections or more.
FaceSearchOutcome SearchFaces(const PData& p, const FaceSearchReading& reading);

/// The faces of p's diagram as sets of edges, ascending.
std::vector<EdgeSet> FaceSets(const PData& p);

}  // namespace tact::knot::thesis

/// @file
/// The knot graph of a code [thesis, Definition 7], on its own: intersections and the segments between them.
/// Model   Vertices from 0 by first columns; edge e_k, at [k - 1], joins the intersections of columns k and k + 1.
/// Errors  Refused.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "provers/check/knot_code.h"

namespace tact::check {

inline constexpr int kMostGraphColumns = 200;

struct KnotGraph {
  int vertices = 0;
  std::vector<int> vertex_of;  // of column i at [i - 1]
  std::vector<std::pair<int, int>> edges;
};

KnotGraph GraphOf(const KnotCode& code);
/// Of each face the edges that it has on a side, ascending; an edge with one face on both sides stands there twice.
std::vector<std::vector<int>> FaceEdges(const KnotCode& code);
/// Whether no columns i..j, i < j, but all of them hold their own mates [thesis, Definition 6].
bool IsIrreducible(const KnotCode& code);
/// How many pieces the graph of so many vertices is in, without some of them.
int CountPieces(int vertices, const std::vector<std::pair<int, int>>& edges, const std::vector<int>& without);

/// The member "p_data": irreducible, on a sphere, at least so many intersections and at most kMostGraphColumns columns.
KnotCode ReadIrreducibleCode(const Value& certificate, int least_crossings);
/// A list of edge numbers k, ascending.
std::vector<int> ReadEdges(const Value& value, const KnotCode& code);

}  // namespace tact::check

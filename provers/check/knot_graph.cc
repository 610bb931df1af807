#include "provers/check/knot_graph.h"

#include <algorithm>
#include <numeric>

namespace tact::check {
namespace {

std::size_t Index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

KnotGraph GraphOf(const KnotCode& code) {
  KnotGraph graph;
  for (int i = 1; i <= code.columns(); ++i) {
    const bool is_new = code.mate(i) > i;
    graph.vertex_of.push_back(is_new ? graph.vertices : graph.vertex_of[Index(code.mate(i)) - 1]);
    graph.vertices += is_new ? 1 : 0;
  }
  for (std::size_t i = 1; i < graph.vertex_of.size(); ++i)
    graph.edges.emplace_back(graph.vertex_of[i - 1], graph.vertex_of[i]);
  return graph;
}

std::vector<std::vector<int>> FaceEdges(const KnotCode& code) {
  const std::vector<int> face = FacesOfCorners(code);
  std::vector<std::vector<int>> edges(Index(CountFaces(code)));
  for (int k = 1; k < code.columns(); ++k) {
    // Ahead of column k on the left and on the right.
    for (const int corner : {0, 1}) edges[Index(face[Index(4 * (k - 1) + corner)])].push_back(k);
  }
  return edges;
}

bool IsIrreducible(const KnotCode& code) {
  const int n = code.columns();
  for (int i = 1; i <= n; ++i) {
    int least = i, most = i;
    for (int j = i; j <= n; ++j) {
      least = std::min(least, code.mate(j));
      most = std::max(most, code.mate(j));
      if (i < j && (i != 1 || j != n) && i <= least && most <= j) return false;
    }
  }
  return true;
}

int CountPieces(int vertices, const std::vector<std::pair<int, int>>& edges,
                const std::vector<int>& without) {
  std::vector<int> piece(Index(vertices));
  std::iota(piece.begin(), piece.end(), 0);
  const auto out = [&](int v) { return std::find(without.begin(), without.end(), v) != without.end(); };
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : edges) {
      if (out(a) || out(b) || piece[Index(a)] == piece[Index(b)]) continue;
      piece[Index(a)] = piece[Index(b)] = std::min(piece[Index(a)], piece[Index(b)]);
      changed = true;
    }
  }
  int pieces = 0;
  for (int v = 0; v < vertices; ++v) pieces += !out(v) && piece[Index(v)] == v ? 1 : 0;
  return pieces;
}

KnotCode ReadIrreducibleCode(const Value& certificate, int least_crossings) {
  const Value& text = At(certificate, "p_data");
  KnotCode code = ReadCodeOnSphere(text);
  if (code.columns() < 2 * least_crossings || code.columns() > kMostGraphColumns)
    throw Refused(&text, "fewer intersections than the statement is about, or more than this checker tries");
  if (!IsIrreducible(code)) throw Refused(&text, "some columns hold their own mates: reducible");
  return code;
}

std::vector<int> ReadEdges(const Value& value, const KnotCode& code) {
  std::vector<int> edges;
  for (const Value& number : AsArray(value)) {
    const int k = static_cast<int>(AsIndex(number, Index(std::max(code.columns(), 1))));
    if (k == 0 || (!edges.empty() && k < edges.back()))
      throw Refused(&number, "edges count from 1 and ascend");
    edges.push_back(k);
  }
  return edges;
}

}  // namespace tact::check

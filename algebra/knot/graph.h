/// @file
/// Small graphs, loops and parallel edges allowed: what is left of them without some vertices.
/// Model   k-connected: more than k vertices, and connected without any k - 1 of them. Loops and parallel edges play no
///         part.
/// Cost    O(m) for a set of vertices; sets are tried one by one.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace tact::knot {

struct Graph {
  int vertices = 0;                        // from 0
  std::vector<std::pair<int, int>> edges;  // loops and repetitions are allowed

  friend bool operator==(const Graph&, const Graph&) = default;
};

/// Of the graph without those vertices and their edges; 0 if no vertex is left.
int CountComponents(const Graph& graph, const std::vector<int>& without = {});

/// The first set of `size` vertices, in ascending order, whose removal leaves more than one component.
std::optional<std::vector<int>> FindSeparator(const Graph& graph, int size);

/// Whether the graph is k-connected; k from 1.
bool IsConnected(const Graph& graph, int k);

}  // namespace tact::knot

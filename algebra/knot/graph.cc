#include "algebra/knot/graph.h"

namespace tact::knot {
namespace {

size_t Index(int vertex) { return static_cast<size_t>(vertex); }

// Extends `chosen` by vertices from `next` on.
bool FindFrom(const Graph& graph, int next, int more, std::vector<int>& chosen) {
  if (more == 0) return CountComponents(graph, chosen) > 1;
  for (int v = next; v < graph.vertices; ++v) {
    chosen.push_back(v);
    if (FindFrom(graph, v + 1, more - 1, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

}  // namespace

int CountComponents(const Graph& graph, const std::vector<int>& without) {
  std::vector<std::vector<int>> neighbours(Index(graph.vertices));
  for (const auto& [a, b] : graph.edges) {
    neighbours[Index(a)].push_back(b);
    neighbours[Index(b)].push_back(a);
  }
  std::vector<bool> seen(Index(graph.vertices));
  for (const int v : without) seen[Index(v)] = true;
  int components = 0;
  for (int start = 0; start < graph.vertices; ++start) {
    if (seen[Index(start)]) continue;
    ++components;
    seen[Index(start)] = true;
    std::vector<int> waiting = {start};
    while (!waiting.empty()) {
      const int v = waiting.back();
      waiting.pop_back();
      for (const int w : neighbours[Index(v)]) {
        if (seen[Index(w)]) continue;
        seen[Index(w)] = true;
        waiting.push_back(w);
      }
    }
  }
  return components;
}

std::optional<std::vector<int>> FindSeparator(const Graph& graph, int size) {
  std::vector<int> chosen;
  if (FindFrom(graph, 0, size, chosen)) return chosen;
  return std::nullopt;
}

bool IsConnected(const Graph& graph, int k) {
  if (graph.vertices <= k) return false;
  for (int size = 0; size < k; ++size) {
    if (FindSeparator(graph, size)) return false;
  }
  return true;
}

}  // namespace tact::knot

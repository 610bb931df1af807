#include "algebra/knot/graph.h"

namespace tact::knot {
namespace {

size_t Index(int vertex) { return static_cast<size_t>(vertex); }

// The neighbours of each vertex, made once for many sets of vertices without which the rest is counted.
class Neighbours {
 public:
  explicit Neighbours(const Graph& graph) : of_(Index(graph.vertices)) {
    for (const auto& [a, b] : graph.edges) {
      of_[Index(a)].push_back(b);
      of_[Index(b)].push_back(a);
    }
  }

  int CountComponents(const std::vector<int>& without) {
    seen_.assign(of_.size(), false);
    for (const int v : without) seen_[Index(v)] = true;
    int components = 0;
    for (int start = 0; start < static_cast<int>(of_.size()); ++start) {
      if (seen_[Index(start)]) continue;
      ++components;
      seen_[Index(start)] = true;
      waiting_ = {start};
      while (!waiting_.empty()) {
        const int v = waiting_.back();
        waiting_.pop_back();
        for (const int w : of_[Index(v)]) {
          if (seen_[Index(w)]) continue;
          seen_[Index(w)] = true;
          waiting_.push_back(w);
        }
      }
    }
    return components;
  }

  // Extends `chosen` by vertices from `next` on.
  bool FindSeparator(int next, int more, std::vector<int>& chosen) {
    if (more == 0) return CountComponents(chosen) > 1;
    for (int v = next; v < static_cast<int>(of_.size()); ++v) {
      chosen.push_back(v);
      if (FindSeparator(v + 1, more - 1, chosen)) return true;
      chosen.pop_back();
    }
    return false;
  }

 private:
  std::vector<std::vector<int>> of_;
  std::vector<bool> seen_;
  std::vector<int> waiting_;
};

}  // namespace

int CountComponents(const Graph& graph, const std::vector<int>& without) {
  return Neighbours(graph).CountComponents(without);
}

std::optional<std::vector<int>> FindSeparator(const Graph& graph, int size) {
  std::vector<int> chosen;
  if (Neighbours(graph).FindSeparator(0, size, chosen)) return chosen;
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

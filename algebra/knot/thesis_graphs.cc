#include "algebra/knot/thesis_graphs.h"

#include <algorithm>
#include <set>

#include "algebra/knot/faces.h"

namespace tact::knot {
namespace {

size_t Index(int i) { return static_cast<size_t>(i); }

}  // namespace

std::vector<int> VerticesOfColumns(const PData& p) {
  std::vector<int> vertices(Index(p.columns()) + 1, -1);
  int count = 0;
  for (int i = 1; i <= p.columns(); ++i)
    vertices[Index(i)] = p.sigma(i) > i ? count++ : vertices[Index(p.sigma(i))];
  return vertices;
}

Graph KnotGraph(const PData& p) {
  const std::vector<int> vertices = VerticesOfColumns(p);
  Graph graph{p.crossings(), {}};
  for (int k = 1; k < p.columns(); ++k) graph.edges.emplace_back(vertices[Index(k)], vertices[Index(k) + 1]);
  return graph;
}

std::vector<int> Degrees(const Graph& graph) {
  std::vector<int> degrees(Index(graph.vertices), 0);
  for (const auto& [a, b] : graph.edges) {
    ++degrees[Index(a)];
    ++degrees[Index(b)];
  }
  return degrees;
}

std::vector<EdgeWalk> KnotGraphFaces(const PData& p) {
  const Faces faces(p);
  std::vector<EdgeWalk> walks(Index(faces.count()));
  for (int f = 0; f < faces.count(); ++f) {
    for (const Dart d : faces.walk(f)) {
      if (d.segment != 1 && d.segment != p.segments()) walks[Index(f)].push_back(d.segment - 1);
    }
  }
  return walks;
}

Graph DualGraph(const PData& p, int external) {
  const Faces faces(p);
  Graph graph{faces.count() - (external >= 0 ? 1 : 0), {}};
  const auto number = [&](int face) { return external >= 0 && face > external ? face - 1 : face; };
  for (int segment = 2; segment < p.segments(); ++segment) {
    const int left = faces.left_of({segment, true}), right = faces.left_of({segment, false});
    if (left != external && right != external) graph.edges.emplace_back(number(left), number(right));
  }
  return graph;
}

Graph BarycentricSubdivision(const PData& p, int external) {
  const Graph knot_graph = KnotGraph(p);
  const int edges = static_cast<int>(knot_graph.edges.size());
  Graph graph{knot_graph.vertices + edges, {}};
  const auto middle = [&](int k) { return knot_graph.vertices + k - 1; };
  for (int k = 1; k <= edges; ++k) {
    graph.edges.emplace_back(knot_graph.edges[Index(k) - 1].first, middle(k));
    graph.edges.emplace_back(middle(k), knot_graph.edges[Index(k) - 1].second);
  }
  const auto walks = KnotGraphFaces(p);
  for (int f = 0; f < static_cast<int>(walks.size()); ++f) {
    if (f == external) continue;
    std::set<int> boundary;
    for (const int k : walks[Index(f)]) {
      const auto& [a, b] = knot_graph.edges[Index(k) - 1];
      boundary.insert({a, b, middle(k)});
    }
    for (const int v : boundary) graph.edges.emplace_back(v, graph.vertices);
    ++graph.vertices;
  }
  return graph;
}

}  // namespace tact::knot

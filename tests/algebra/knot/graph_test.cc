#include "algebra/knot/graph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

namespace tact::knot {
namespace {

Graph Complete(int vertices) {
  Graph graph{vertices, {}};
  for (int a = 0; a < vertices; ++a) {
    for (int b = a + 1; b < vertices; ++b) graph.edges.emplace_back(a, b);
  }
  return graph;
}

Graph Circle(int vertices) {
  Graph graph{vertices, {}};
  for (int a = 0; a < vertices; ++a) graph.edges.emplace_back(a, (a + 1) % vertices);
  return graph;
}

Graph Wheel(int spokes) {
  Graph graph = Circle(spokes);
  for (int a = 0; a < spokes; ++a) graph.edges.emplace_back(a, spokes);
  ++graph.vertices;
  return graph;
}

// The highest k to which each is connected, as textbooks have it: n - 1, 2 and 3.
TEST(Graph, CompleteGraphsCirclesAndWheelsAreConnectedAsFarAsTheyMustBe) {
  for (int n = 3; n <= 7; ++n) {
    EXPECT_TRUE(IsConnected(Complete(n), n - 1));
    EXPECT_FALSE(IsConnected(Complete(n), n));
    EXPECT_EQ(IsConnected(Circle(n), 3), false);
    EXPECT_TRUE(IsConnected(Circle(n), 2));
    EXPECT_TRUE(IsConnected(Wheel(n), 3));
    EXPECT_EQ(IsConnected(Wheel(n), 4), false);
  }
}

TEST(Graph, LoopsAndParallelEdgesHoldNothingTogether) {
  const Graph two_digons{3, {{0, 1}, {1, 0}, {1, 2}, {2, 1}, {2, 2}}};
  EXPECT_TRUE(IsConnected(two_digons, 1));
  EXPECT_EQ(FindSeparator(two_digons, 1), (std::vector<int>{1}));
  EXPECT_EQ(CountComponents(two_digons, {1}), 2);
  EXPECT_EQ(CountComponents(two_digons, {0, 1, 2}), 0);
  EXPECT_EQ(CountComponents(Graph{}), 0);
}

// Twin: components by relabelling until nothing changes.
RC_GTEST_PROP(Graph, ComponentsAreClassesOfTheirEdges, ()) {
  const int n = *rc::gen::inRange(1, 9);
  const auto vertex = rc::gen::inRange(0, n);
  const Graph graph{n, *rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(vertex, vertex))};
  const int without = *vertex;
  std::vector<int> label(static_cast<size_t>(n));
  std::iota(label.begin(), label.end(), 0);
  for (int round = 0; round < n; ++round) {
    for (const auto& [a, b] : graph.edges) {
      if (a == without || b == without) continue;
      int& x = label[static_cast<size_t>(a)];
      int& y = label[static_cast<size_t>(b)];
      x = y = std::min(x, y);
    }
  }
  int components = 0;
  for (int v = 0; v < n; ++v) components += v != without && label[static_cast<size_t>(v)] == v ? 1 : 0;
  RC_ASSERT(CountComponents(graph, {without}) == components);
}

}  // namespace
}  // namespace tact::knot

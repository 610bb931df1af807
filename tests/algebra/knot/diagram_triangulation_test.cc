#include "algebra/knot/diagram_triangulation.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algebra/error.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

using Edge = std::pair<int, int>;

// Directed edges of the triangles; each at most once on an oriented surface without doubled sides.
std::multiset<Edge> DirectedEdges(const DiagramTriangulation& t) {
  std::multiset<Edge> edges;
  for (const auto& triangle : t.triangles) {
    for (size_t k = 0; k < 3; ++k) edges.insert({triangle[k], triangle[(k + 1) % 3]});
  }
  return edges;
}

std::set<Edge> BoundaryEdges(const DiagramTriangulation& t) {
  std::set<Edge> edges;  // the ring runs clockwise: backward, it has its triangles on the left
  for (size_t k = 0; k < t.boundary.size(); ++k)
    edges.insert({t.boundary[(k + 1) % t.boundary.size()], t.boundary[k]});
  return edges;
}

void ForEachDrawing(int crossings, const std::function<void(const PData&, int)>& visit) {
  for (int n = 0; n <= crossings; ++n) {
    for (const PData& p : PlanarPData(n)) {
      for (int outer = 0; outer <= n; ++outer) visit(p, outer);
    }
  }
}

// What is left of the graph hangs together; `first`, `second` are taken away, and the outside counts as a vertex joined to the ring.
bool Connected(const DiagramTriangulation& t, const std::vector<std::vector<int>>& neighbours, int first,
               int second) {
  std::vector<bool> seen(neighbours.size(), false);
  seen[static_cast<size_t>(first)] = seen[static_cast<size_t>(second)] = true;
  std::vector<int> stack;
  for (int v = 0; v <= t.vertices && stack.empty(); ++v) {
    if (v != first && v != second) stack.push_back(v);
  }
  seen[static_cast<size_t>(stack[0])] = true;
  size_t count = 3;
  while (!stack.empty()) {
    const int v = stack.back();
    stack.pop_back();
    for (const int next : neighbours[static_cast<size_t>(v)]) {
      if (seen[static_cast<size_t>(next)]) continue;
      seen[static_cast<size_t>(next)] = true;
      ++count;
      stack.push_back(next);
    }
  }
  return count == neighbours.size();
}

// Simple, a disc by Euler's formula, each edge between two triangles or on the ring: for all planar P-data of up to 3
// intersections, reducible or not, and each face outside.
TEST(DiagramTriangulation, IsASimpleDiscWithoutChords) {
  ForEachDrawing(3, [](const PData& p, int outer) {
    const auto t = TriangulateDiagram(p, outer);
    const auto directed = DirectedEdges(t);
    const auto boundary = BoundaryEdges(t);
    ASSERT_EQ(boundary.size(), t.boundary.size());
    ASSERT_GE(boundary.size(), 3u);
    std::set<Edge> undirected;
    for (const auto& [a, b] : directed) {
      ASSERT_NE(a, b) << p.ToJson();
      ASSERT_EQ(directed.count({a, b}), 1u) << p.ToJson();
      ASSERT_EQ(directed.count({b, a}), boundary.contains({a, b}) ? 0u : 1u) << p.ToJson();
      ASSERT_TRUE(!t.OnBoundary(a) || !t.OnBoundary(b) || boundary.contains({a, b}) ||
                  boundary.contains({b, a}));
      undirected.insert({std::min(a, b), std::max(a, b)});
    }
    ASSERT_EQ(t.vertices - static_cast<int>(undirected.size()) + static_cast<int>(t.triangles.size()), 1);
  });
}

TEST(DiagramTriangulation, WithTheOutsideAsAVertexIsThreeConnected) {
  ForEachDrawing(2, [](const PData& p, int outer) {
    const auto t = TriangulateDiagram(p, outer);
    std::vector<std::vector<int>> neighbours(static_cast<size_t>(t.vertices) + 1);
    for (const auto& [a, b] : DirectedEdges(t)) {
      neighbours[static_cast<size_t>(a)].push_back(b);
      neighbours[static_cast<size_t>(b)].push_back(a);
    }
    for (const int v : t.boundary) {
      neighbours[static_cast<size_t>(v)].push_back(t.vertices);
      neighbours.back().push_back(v);
    }
    for (int first = 0; first <= t.vertices; ++first) {
      for (int second = first + 1; second <= t.vertices; ++second)
        ASSERT_TRUE(Connected(t, neighbours, first, second)) << p.ToJson() << first << ' ' << second;
    }
  });
}

TEST(DiagramTriangulation, TheRopeRunsAlongEdgesAndMeetsItselfAtItsColumns) {
  ForEachDrawing(3, [](const PData& p, int outer) {
    const auto t = TriangulateDiagram(p, outer);
    const auto directed = DirectedEdges(t);
    std::map<int, std::vector<int>> met;  // the places of each vertex in the rope
    for (size_t k = 0; k < t.rope.size(); ++k) {
      met[t.rope[k]].push_back(static_cast<int>(k));
      if (k > 0) {
        ASSERT_EQ(directed.count({t.rope[k - 1], t.rope[k]}), 1u);
      }
    }
    ASSERT_EQ(static_cast<int>(t.place.size()), p.columns());
    int twice = 0;
    for (const auto& [vertex, places] : met) {
      ASSERT_LE(places.size(), 2u);
      twice += places.size() == 2 ? 1 : 0;
    }
    ASSERT_EQ(twice, p.crossings());
    for (int i = 1; i <= p.columns(); ++i) {
      const auto at = [&](int column) {
        return t.rope[static_cast<size_t>(t.place[static_cast<size_t>(column) - 1])];
      };
      ASSERT_EQ(at(i), at(p.sigma(i)));
    }
  });
}

// The ring is joined to points of the outer face's segments and of no other.
TEST(DiagramTriangulation, TheRingGoesRoundTheFaceThatIsOutside) {
  ForEachDrawing(3, [](const PData& p, int outer) {
    const auto t = TriangulateDiagram(p, outer);
    std::map<int, int> segment_of;  // of the points inside segments
    int segment = 1;
    for (size_t k = 0; k < t.rope.size(); ++k) {
      if (segment <= p.columns() && static_cast<int>(k) == t.place[static_cast<size_t>(segment) - 1]) {
        ++segment;
      } else {
        segment_of[t.rope[k]] = segment;
      }
    }
    std::set<int> joined, expected;
    for (const auto& [a, b] : DirectedEdges(t)) {
      if (t.OnBoundary(a) && segment_of.contains(b)) joined.insert(segment_of[b]);
    }
    const Faces faces(p);
    for (const Dart d : faces.walk(outer)) expected.insert(d.segment);
    ASSERT_EQ(joined, expected) << p.ToJson() << " face " << outer;
  });
}

TEST(DiagramTriangulation, MorePointsAreAddedWhereAskedFor) {
  const PData overhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]
  const auto plain = TriangulateDiagram(overhand),
             more = TriangulateDiagram(overhand, 0, {0, 3, 0, 0, 0, 0, 1});
  EXPECT_EQ(more.rope.size(), plain.rope.size() + 4);
}

TEST(DiagramTriangulation, ATorusAFaceThatIsNoneAndTooFewNumbersAreRefused) {
  const PData torus({3, 4, 1, 2}, {3, 3, 4, 4}), loop({2, 1}, {1, 2});
  EXPECT_THROW(TriangulateDiagram(torus), PreconditionError);
  EXPECT_THROW(TriangulateDiagram(loop, 2), PreconditionError);
  EXPECT_THROW(TriangulateDiagram(loop, -1), PreconditionError);
  EXPECT_THROW(TriangulateDiagram(loop, 0, {1, 1}), PreconditionError);
}

}  // namespace
}  // namespace tact::knot

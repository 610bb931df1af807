#include "algebra/knot/thesis_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

TEST(ThesisGraphs, OfTheOverhandKnotAreThoseOfTheThesis) {
  // "three vertices and five edges e1 = {v1, v2}, e2 = {v2, v3}, e3 = {v3, v1}, e4 = {v1, v2}, e5 = {v2, v3}"
  EXPECT_EQ(KnotGraph(kOverhand), (Graph{3, {{0, 1}, {1, 2}, {2, 0}, {0, 1}, {1, 2}}}));
  std::vector<EdgeWalk> faces = KnotGraphFaces(kOverhand);
  for (EdgeWalk& face : faces) std::sort(face.begin(), face.end());
  std::sort(faces.begin(), faces.end());
  EXPECT_EQ(faces, (std::vector<EdgeWalk>{{1, 3, 5}, {1, 4}, {2, 3, 4}, {2, 5}}));
  // By hand: each edge parts two faces.
  auto neighbours = Degrees(DualGraph(kOverhand, -1));
  std::sort(neighbours.begin(), neighbours.end());
  EXPECT_EQ(neighbours, (std::vector<int>{2, 2, 3, 3}));
  for (int external = 0; external < 4; ++external) {
    EXPECT_EQ(DualGraph(kOverhand, external).vertices, 3);
    // 3 intersections, 5 middles, 3 faces; halves, and twice as many spokes as a face has edges.
    const Graph subdivision = BarycentricSubdivision(kOverhand, external);
    const size_t boundary = KnotGraphFaces(kOverhand)[static_cast<size_t>(external)].size();
    EXPECT_EQ(subdivision.vertices, 11);
    EXPECT_EQ(subdivision.edges.size(), 10 + 2 * (10 - boundary));
  }
}

TEST(ThesisGraphs, OneIntersectionAndNone) {
  const PData kink({2, 1}, {1, 2});
  EXPECT_EQ(KnotGraph(kink), (Graph{1, {{0, 0}}}));
  EXPECT_EQ(KnotGraphFaces(kink), (std::vector<EdgeWalk>{{1}, {1}}));
  EXPECT_EQ(BarycentricSubdivision(kink, 0), (Graph{3, {{0, 1}, {1, 0}, {0, 2}, {1, 2}}}));
  EXPECT_EQ(KnotGraph(PData()), Graph{});
  EXPECT_EQ(KnotGraphFaces(PData()), std::vector<EdgeWalk>{{}});
}

TEST(ThesisGraphs, EachEdgeIsTwiceOnFacesAndEulersFormulaHolds) {
  for (int c = 1; c <= 3; ++c) {
    ForEachPData(c, [&](const PData& p) {
      const Graph graph = KnotGraph(p);
      std::vector<int> used(graph.edges.size() + 1, 0);
      const auto faces = KnotGraphFaces(p);
      for (const EdgeWalk& face : faces) {
        for (const int k : face) ++used[static_cast<size_t>(k)];
      }
      EXPECT_EQ(std::count(used.begin() + 1, used.end(), 2), static_cast<long>(graph.edges.size()));
      EXPECT_EQ(graph.vertices - static_cast<int>(graph.edges.size()) + static_cast<int>(faces.size()),
                2 - 2 * Genus(p));
      EXPECT_EQ(CountComponents(graph), 1);
    });
  }
}

}  // namespace
}  // namespace tact::knot

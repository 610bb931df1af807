#include "algebra/knot/thesis_graphs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

// Propositions 7 and 8 of the thesis, beyond the bound of the ledger. Random external faces: 20 intersections have 3000
// pairs of vertices for each.
RC_GTEST_PROP(ThesisGraphsLaw, IrreducibleKnotGraphsHaveConnectedDualsAndThreeConnectedSubdivisions,
              (uint64_t seed)) {
  std::mt19937_64 random(seed);
  const PData p = RandomIrreduciblePData(random, *rc::gen::inRange(14, 30));
  RC_PRE(p.crossings() > 1);
  RC_CLASSIFY(p.crossings() > 7, "beyond the bound");
  for (int external = 0; external <= p.crossings(); ++external)
    RC_ASSERT(CountComponents(DualGraph(p, external)) == 1);
  const int external = static_cast<int>(random() % static_cast<uint64_t>(p.crossings() + 1));
  RC_ASSERT(IsConnected(BarycentricSubdivision(p, external), 3));
}

// An edge that the same face has on both sides, a vertex that parts the graph: reducible P-data only.
RC_GTEST_PROP(ThesisGraphsLaw, NoEdgeIsTwiceOnAFaceOfAnIrreducibleKnotGraph, (uint64_t seed)) {
  std::mt19937_64 random(seed);
  const PData p = RandomIrreduciblePData(random, *rc::gen::inRange(14, 30));
  RC_ASSERT(p.crossings() < 2 || IsConnected(KnotGraph(p), p.crossings() > 2 ? 2 : 1));
  for (EdgeWalk walk : KnotGraphFaces(p)) {
    std::sort(walk.begin(), walk.end());
    RC_ASSERT(std::adjacent_find(walk.begin(), walk.end()) == walk.end());
  }
}

}  // namespace
}  // namespace tact::knot

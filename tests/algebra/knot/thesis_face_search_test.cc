#include "algebra/knot/thesis_face_search.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>

#include "algebra/error.h"
#include "algebra/knot/reducible.h"
#include "algebra/knot/thesis_graphs.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot::thesis {
namespace {

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

EdgeSet Set(std::initializer_list<int> edges) {
  EdgeSet set = 0;
  for (const int k : edges) set |= EdgeSet{1} << (k - 1);
  return set;
}

// [thesis, 5.4.1]: the four faces, and the two loops that the caution excludes.
TEST(ThesisFaceSearch, OfTheOverhandKnotDoesWhatTheThesisPrints) {
  const std::vector<EdgeSet> faces = {Set({1, 4}), Set({2, 5}), Set({1, 5, 3}), Set({4, 2, 3})};
  for (const EdgeSet face : faces) {
    const auto sets = FaceSets(kOverhand);
    EXPECT_EQ(std::count(sets.begin(), sets.end(), face), 1);
  }
  const auto all = FindLoops(kOverhand, Caution::kNone), some = FindLoops(kOverhand, Caution::kEdges);
  EXPECT_EQ(all.size(), 6u);
  EXPECT_EQ(some.size(), 4u);
  for (const EdgeSet loop : {Set({1, 2, 3}), Set({3, 4, 5})}) {
    EXPECT_EQ(std::count(all.begin(), all.end(), loop), 1);
    EXPECT_EQ(std::count(some.begin(), some.end(), loop), 0);
  }
  const auto outcome = SearchFaces(kOverhand, {});
  EXPECT_TRUE(outcome.right && !outcome.wrong);
  // Counted as in Definition 2 the caution forbids the face {e4, e2, e3}: e3 and e4 are segments 4 and 5.
  EXPECT_FALSE(SearchFaces(kOverhand, {Caution::kSegments, LoopOrder::kShortestFirst}).right);
}

// Twin: loops are the sets of edges that meet each vertex twice or never and hang together.
TEST(ThesisFaceSearch, LoopsAreTheEdgeSetsThatAreSimpleClosedPaths) {
  for (const PData& p : PlanarPData(3)) {
    const Graph graph = KnotGraph(p);
    std::vector<EdgeSet> loops;
    for (EdgeSet set = 1; set < EdgeSet{1} << graph.edges.size(); ++set) {
      Graph part{graph.vertices, {}};
      for (size_t e = 0; e < graph.edges.size(); ++e) {
        if ((set >> e & 1) != 0) part.edges.push_back(graph.edges[e]);
      }
      const auto degrees = Degrees(part);
      const auto unused = std::count(degrees.begin(), degrees.end(), 0);
      const auto twice = std::count(degrees.begin(), degrees.end(), 2);
      if (unused + twice == graph.vertices && CountComponents(part) == unused + 1) loops.push_back(set);
    }
    auto found = FindLoops(p, Caution::kNone);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                               [](EdgeSet a, EdgeSet b) { return std::popcount(a) < std::popcount(b); }));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, loops) << p.ToJson();
  }
}

TEST(ThesisFaceSearch, WhatItChoosesWronglyIsAllowedAndNoFace) {
  const PData one({4, 7, 8, 1, 10, 9, 2, 3, 6, 5}, {3, 1, 3, 4, 3, 1, 2, 4, 2, 4});
  const PData other({6, 9, 8, 7, 10, 1, 4, 3, 2, 5}, {3, 1, 3, 1, 3, 4, 2, 4, 2, 4});
  for (const auto& [order, p] : {std::pair(LoopOrder::kShortestFirst, one),
                                 {LoopOrder::kEdgeByEdge, one},
                                 {LoopOrder::kCornerByCorner, other}}) {
    ASSERT_TRUE(IsPlanar(p) && IsIrreducible(p));
    const auto outcome = SearchFaces(p, {Caution::kEdges, order});
    ASSERT_TRUE(outcome.wrong && outcome.right && !outcome.stuck);
    const auto loops = FindLoops(p, Caution::kEdges), faces = FaceSets(p);
    for (const EdgeSet loop : outcome.chosen) {
      EXPECT_EQ(std::count(loops.begin(), loops.end(), loop), 1);
      EXPECT_EQ(std::count(faces.begin(), faces.end(), loop), loop == outcome.chosen.back() ? 0 : 1);
    }
  }
}

// The caution is right beyond the bound of the ledger, too: no face of irreducible P-data is forbidden.
RC_GTEST_PROP(ThesisFaceSearch, TheCautionForbidsNoFace, (uint64_t seed)) {
  std::mt19937_64 random(seed);
  const PData p = RandomIrreduciblePData(random, *rc::gen::inRange(12, 17));
  RC_PRE(p.crossings() > 1);
  for (const EdgeSet face : FaceSets(p)) RC_ASSERT(Allows(p, Caution::kEdges, face));
}

TEST(ThesisFaceSearch, MoreEdgesThanASetHoldsAreRefused) {
  std::mt19937_64 random(1);
  EXPECT_THROW(FindLoops(RandomPData(random, 17), Caution::kNone), PreconditionError);
}

}  // namespace
}  // namespace tact::knot::thesis

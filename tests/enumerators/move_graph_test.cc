#include "enumerators/move_graph.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algebra/error.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::enumerators {
namespace {

using knot::Move;
using knot::MoveKind;
using knot::MoveRules;
using knot::PData;
using knot::RopeEnd;

// OEIS A373325 counts the codes, each with two heights an intersection.
TEST(MoveGraph, NodesAreTheCodesOfOeisTimesTheHeights) {
  const MoveGraph graph(5);
  const uint32_t codes[] = {1, 2, 10, 66, 498, 4072};
  for (int n = 0; n <= 5; ++n)
    EXPECT_EQ(graph.first(n + 1) - graph.first(n), codes[n] << n) << n << " intersections";
}

TEST(MoveGraph, NodesAreThePlanarPData) {
  const MoveGraph graph(3);
  uint32_t nodes = 0;
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : knot::PlanarPData(n)) {
      const uint32_t node = graph.Find(p);
      ASSERT_NE(node, knot::PDataStore::kNone);
      ASSERT_EQ(graph.At(node), p);
      ASSERT_EQ(graph.CrossingsOf(node), n);
      ++nodes;
    }
  }
  EXPECT_EQ(nodes, graph.nodes());
}

// The kinds of all single moves between all pairs of P-data, found by detection.
TEST(MoveGraph, PairsAndMovesAreThoseThatDetectionFinds) {
  const MoveGraph graph(3);
  const MoveGraphCounts counts = CountMoveGraph(graph);
  std::map<uint32_t, uint64_t> by_kinds;
  std::map<std::pair<int, int>, std::pair<uint64_t, uint64_t>> edges;  // kind, intersections: moves, pairs
  uint64_t several = 0;
  std::vector<PData> world;
  for (int n = 0; n <= 3; ++n) {
    for (const PData& p : knot::PlanarPData(n)) world.push_back(p);
  }
  for (size_t a = 0; a < world.size(); ++a) {
    for (size_t b = a + 1; b < world.size(); ++b) {
      uint32_t kinds = 0;
      const auto moves = DetectMoves(world[a], world[b]);
      for (const Move& move : moves) {
        const int kind = move.kind == MoveKind::kCross ? (move.end == RopeEnd::kSelective ? 3 : 4)
                                                       : static_cast<int>(move.kind);
        auto& [count, pairs] = edges[{kind, world[a].crossings()}];
        ++count;
        if ((kinds >> kind & 1) == 0) ++pairs;
        kinds |= 1u << kind;
      }
      if (kinds != 0) ++by_kinds[kinds];
      if (moves.size() > 1) ++several;
    }
  }
  EXPECT_EQ(counts.pairs_by_kinds, by_kinds);
  EXPECT_EQ(counts.pairs_with_several_moves, several);
  for (size_t n = 0; n < counts.edges.size(); ++n) {
    for (size_t kind = 0; kind < kEdgeKinds; ++kind) {
      const auto& [moves, pairs] = edges[{static_cast<int>(kind), static_cast<int>(n)}];
      EXPECT_EQ(counts.edges[n][kind].moves, moves) << n << " " << kind;
      EXPECT_EQ(counts.edges[n][kind].pairs, pairs) << n << " " << kind;
    }
  }
}

// To four intersections no shortest sequence leads over more: the search, which has no such bound, agrees.
TEST(MoveGraph, DistancesAreTheLengthsOfShortestSequences) {
  const MoveGraph graph(4);
  for (const MoveRules& rules :
       {MoveRules{}, MoveRules{.r1 = false}, MoveRules{.held = RopeEnd::kSelective}}) {
    const auto distance = graph.Distances(rules);
    for (uint32_t node = 0; node < graph.nodes(); node += node < graph.first(4) ? 1 : 7) {
      const auto tying = TieShortest(graph.At(node), {.rules = rules});
      ASSERT_EQ(tying.excluded_below, distance[node]) << graph.At(node).ToJson();
    }
  }
}

TEST(MoveGraph, ClassesAreClosedUnderMovesAndLedByTheirLeast) {
  const MoveGraph graph(3);
  const MoveRules rules{.cross = false};
  const auto classes = graph.Classes(rules);
  std::set<uint32_t> leaders;
  for (uint32_t node = 0; node < graph.nodes(); ++node) {
    leaders.insert(classes[node]);
    ASSERT_LE(classes[node], node);
    ASSERT_EQ(classes[classes[node]], classes[node]);
    for (const Move& move : AllMoves(graph.At(node), 3)) {
      if (rules.Allow(move)) {
        ASSERT_EQ(classes[graph.Find(Apply(graph.At(node), move))], classes[node]);
      }
    }
  }
  EXPECT_EQ(leaders.size(), CountMoveGraph(graph).classes);
  // Reached from the straight rope by Reidemeister moves just if it is of its class.
  const auto distance = graph.Distances(rules);
  for (uint32_t node = 0; node < graph.nodes(); ++node)
    ASSERT_EQ(distance[node] != MoveGraph::kUnreached, classes[node] == 0);
}

TEST(MoveGraph, TooManyIntersectionsAreRefused) {
  EXPECT_THROW(MoveGraph(7), PreconditionError);
  EXPECT_THROW(MoveGraph(-1), PreconditionError);
}

}  // namespace
}  // namespace tact::enumerators

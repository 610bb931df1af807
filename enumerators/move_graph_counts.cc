// What `tact enumerate moves` counts.
#include <map>
#include <set>

#include "algebra/knot/bracket.h"
#include "enumerators/move_graph.h"

namespace tact::enumerators {
namespace {

void CountEdges(const MoveGraph& graph, MoveGraphCounts& counts) {
  for (uint32_t node = 0; node < graph.nodes(); ++node) {
    for (const MoveGraph::Edge* e = graph.begin(node); e != graph.end(node);) {
      const uint32_t to = e->to;
      uint32_t kinds = 0, moves = 0;
      // An R3 is kept at both nodes.
      const bool once = to < node;
      auto& edges = counts.edges[static_cast<size_t>(graph.CrossingsOf(to))];
      for (; e != graph.end(node) && e->to == to; ++e, ++moves) {
        if (!once) continue;
        ++edges[e->kind].moves;
        if ((kinds >> e->kind & 1) == 0) ++edges[e->kind].pairs;
        kinds |= 1u << e->kind;
      }
      if (!once) continue;
      ++counts.pairs_by_kinds[kinds];
      if (moves > 1) ++counts.pairs_with_several_moves;
    }
  }
}

void CountClasses(const MoveGraph& graph, MoveGraphCounts& counts) {
  const auto classes = graph.Classes({.cross = false});
  std::set<knot::BracketPolynomial> brackets;
  std::vector<bool> is_one(graph.nodes(), false);
  for (uint32_t node = 0; node < graph.nodes(); ++node) {
    if (classes[node] == node) {
      ++counts.classes;
      const auto bracket = NormalizedBracket(graph.At(node));
      is_one[node] = bracket == knot::OneBracket();
      brackets.insert(bracket);
    }
    const auto n = static_cast<size_t>(graph.CrossingsOf(node));
    if (classes[node] == 0) ++counts.of_the_straight_rope[n];
    if (is_one[classes[node]]) ++counts.with_its_bracket[n];
  }
  counts.class_brackets = brackets.size();
}

}  // namespace

MoveGraphCounts CountMoveGraph(const MoveGraph& graph) {
  const auto levels = static_cast<size_t>(graph.most_crossings()) + 1;
  MoveGraphCounts counts;
  counts.nodes.resize(levels);
  counts.self_equivalent.resize(levels);
  counts.edges.resize(levels);
  counts.at_distance.resize(levels);
  counts.of_the_straight_rope.resize(levels);
  counts.with_its_bracket.resize(levels);
  const auto distance = graph.Distances({});
  for (uint32_t node = 0; node < graph.nodes(); ++node) {
    const auto n = static_cast<size_t>(graph.CrossingsOf(node));
    ++counts.nodes[n];
    const knot::PData p = graph.At(node);
    if (EquivalentPData(p) == p) ++counts.self_equivalent[n];
    auto& histogram = counts.at_distance[n];
    if (histogram.size() <= distance[node]) histogram.resize(distance[node] + size_t{1});
    ++histogram[distance[node]];
  }
  CountEdges(graph, counts);
  CountClasses(graph, counts);
  return counts;
}

}  // namespace tact::enumerators

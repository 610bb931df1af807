#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "enumerators/move_graph.h"

namespace tact::cli {
namespace {

using enumerators::EdgeKind;
using enumerators::kEdgeKinds;
using enumerators::MoveGraphCounts;

std::string Text(uint64_t number) { return std::to_string(number); }

std::vector<EdgeKind> KindsOf(uint32_t set) {
  std::vector<EdgeKind> kinds;
  for (size_t k = 0; k < kEdgeKinds; ++k) {
    if ((set >> k & 1) != 0) kinds.push_back(static_cast<EdgeKind>(k));
  }
  return kinds;
}

uint64_t Pairs(const MoveGraphCounts& counts, bool several_kinds) {
  uint64_t pairs = 0;
  for (const auto& [kinds, count] : counts.pairs_by_kinds) {
    if (!several_kinds || KindsOf(kinds).size() > 1) pairs += count;
  }
  return pairs;
}

// Calls print(kind, from, to, edges) where there are any.
template <typename Print>
void ForEachEdges(const MoveGraphCounts& counts, const Print& print) {
  for (size_t k = 0; k < kEdgeKinds; ++k) {
    const auto kind = static_cast<EdgeKind>(k);
    const size_t more = kind == EdgeKind::kR3 ? 0 : kind == EdgeKind::kR2 ? 2 : 1;
    for (size_t n = 0; n < counts.edges.size(); ++n) {
      if (counts.edges[n][k].moves > 0) print(kind, n, n + more, counts.edges[n][k]);
    }
  }
}

std::string ToJson(const MoveGraphCounts& counts, uint64_t p_data) {
  std::string text =
      "{\"crossings\":" + Text(counts.nodes.size() - 1) + ",\"p_data\":" + Text(p_data) + ",\"levels\":[";
  for (size_t n = 0; n < counts.nodes.size(); ++n) {
    text += std::string(n == 0 ? "" : ",") + "{\"crossings\":" + Text(n) +
            ",\"p_data\":" + Text(counts.nodes[n]) +
            ",\"self_equivalent\":" + Text(counts.self_equivalent[n]) + ",\"steps\":[" +
            Join(counts.at_distance[n], ",", Text) +
            "],\"straight_class\":" + Text(counts.of_the_straight_rope[n]) +
            ",\"straight_bracket\":" + Text(counts.with_its_bracket[n]) + "}";
  }
  text += "],\"edges\":[";
  std::string between;
  ForEachEdges(counts, [&](EdgeKind kind, size_t from, size_t to, const MoveGraphCounts::Edges& edges) {
    text += between + "{\"kind\":\"" + ToString(kind) + "\",\"from\":" + Text(from) + ",\"to\":" + Text(to) +
            ",\"moves\":" + Text(edges.moves) + ",\"pairs\":" + Text(edges.pairs) + "}";
    between = ",";
  });
  text += "],\"pairs\":" + Text(Pairs(counts, false)) + ",\"pairs_by_kinds\":[" +
          Join(counts.pairs_by_kinds, ",",
               [](const auto& item) {
                 return "{\"kinds\":[" +
                        Join(KindsOf(item.first), ",",
                             [](EdgeKind kind) { return "\"" + std::string(ToString(kind)) + "\""; }) +
                        "],\"pairs\":" + Text(item.second) + "}";
               }) +
          "],\"pairs_with_several_kinds\":" + Text(Pairs(counts, true)) +
          ",\"pairs_with_several_moves\":" + Text(counts.pairs_with_several_moves) +
          ",\"without_cross\":{\"classes\":" + Text(counts.classes) +
          ",\"brackets\":" + Text(counts.class_brackets) + "}}\n";
  return text;
}

std::string Cell(const std::string& text, size_t width) {
  return std::string(width > text.size() ? width - text.size() : 1, ' ') + text;
}

std::string ToTable(const MoveGraphCounts& counts) {
  std::string text = "P-data, and how many lie so many steps from the straight rope\n";
  text += " n      P-data  self-equivalent  without Cross: straight  steps 0, 1, 2, ...\n";
  for (size_t n = 0; n < counts.nodes.size(); ++n) {
    text += Cell(Text(n), 2) + Cell(Text(counts.nodes[n]), 12) + Cell(Text(counts.self_equivalent[n]), 17) +
            Cell(Text(counts.of_the_straight_rope[n]), 25) + "  " + Join(counts.at_distance[n], " ", Text) +
            "\n";
  }
  text += "\nMoves\n kind              n -> n       moves  pairs of P-data\n";
  ForEachEdges(counts, [&](EdgeKind kind, size_t from, size_t to, const MoveGraphCounts::Edges& edges) {
    const std::string name = ToString(kind);
    text += " " + name + std::string(18 - name.size(), ' ') + Text(from) + " -> " + Text(to) +
            Cell(Text(edges.moves), 12) + Cell(Text(edges.pairs), 17) + "\n";
  });
  text += "\nPairs of P-data by the kinds of move that join them\n";
  for (const auto& [kinds, pairs] : counts.pairs_by_kinds) {
    text += Cell(Text(pairs), 12) + "  " + Join(KindsOf(kinds), ", ", enumerators::ToString) + "\n";
  }
  text += Cell(Text(Pairs(counts, false)), 12) + "  in all, " + Text(Pairs(counts, true)) +
          " by several kinds, " + Text(counts.pairs_with_several_moves) + " by several moves\n";
  text += "\nWithout Cross moves: " + Text(counts.classes) + " classes, at least " +
          Text(counts.class_brackets) +
          " of them different however many intersections there are on the way (bracket polynomial)\n";
  for (size_t n = 0; n < counts.nodes.size(); ++n) {
    const uint64_t hard = counts.with_its_bracket[n] - counts.of_the_straight_rope[n];
    if (hard > 0) {
      text += Text(hard) + " with " + Text(n) +
              " intersections have the straight rope's bracket and are not in its class\n";
    }
  }
  return text;
}

}  // namespace

ExitStatus RunEnumerateMoves(const MoveGraphOptions& options) {
  constexpr int kMost = enumerators::MoveGraph::kMostCrossings;
  if (options.crossings < 0 || options.crossings > kMost) {
    throw InputError("--crossings: expected 0 to " + std::to_string(kMost) + ", got " +
                     std::to_string(options.crossings));
  }
  const enumerators::MoveGraph graph(static_cast<int>(options.crossings));
  const MoveGraphCounts counts = CountMoveGraph(graph);
  Output out;
  out << (options.json ? ToJson(counts, graph.nodes()) : ToTable(counts));
  out.Flush();
  return kAnswered;
}

}  // namespace tact::cli

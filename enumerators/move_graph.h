/// @file
/// The move graph: all P-data of a sphere with at most so many intersections, joined by single moves.
/// Model   Nodes are P-data as read off from one end, numbered from 0 by intersections, then in the order of planar_p_data.h. An edge
///         is kept at its node with more intersections, an R3 at both its nodes. A way that leads over more intersections
///         than the bound is no way in this graph.
/// Errors  PreconditionError: a bound beyond kMostCrossings.
/// Cost    4 million moves a second or so; 5 intersections are 138,845 nodes and half a second, 6 are 2.4 million.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "algebra/knot/p_data_store.h"
#include "algebra/knot/tying.h"

namespace tact::enumerators {

/// Moves between two P-data by kind; a Cross by the end that makes it.
enum class EdgeKind : uint8_t { kR1, kR2, kR3, kCrossSelective, kCrossOther };
inline constexpr size_t kEdgeKinds = 5;
/// "R1", "R2", "R3", "Cross selective", "Cross other".
const char* ToString(EdgeKind kind);

class MoveGraph {
 public:
  static constexpr int kMostCrossings = 6;

  struct Edge {
    uint32_t to : 29;
    uint32_t kind : 3;
  };

  explicit MoveGraph(int most_crossings);

  int most_crossings() const { return static_cast<int>(first_.size()) - 2; }
  uint32_t nodes() const { return first_.back(); }
  /// Nodes first(n) to first(n + 1) - 1 have n intersections.
  uint32_t first(int crossings) const { return first_[static_cast<size_t>(crossings)]; }
  int CrossingsOf(uint32_t node) const;
  knot::PData At(uint32_t node) const { return store_.Get(node); }
  uint32_t Find(const knot::PData& p) const { return store_.Find(p); }

  /// Moves that remove intersections, and R3, sorted by where they lead; a node that two moves lead to comes twice.
  const Edge* begin(uint32_t node) const { return edges_.data() + starts_[node]; }
  const Edge* end(uint32_t node) const { return edges_.data() + starts_[node + size_t{1}]; }

  static constexpr uint8_t kUnreached = 255;
  /// Steps from the straight rope by allowed moves, within the graph.
  std::vector<uint8_t> Distances(const knot::MoveRules& rules) const;
  /// The least node of each node's class: those that allowed moves lead to, within so many intersections.
  std::vector<uint32_t> Classes(const knot::MoveRules& rules, int most_crossings = kMostCrossings) const;

 private:
  knot::PDataStore store_;
  std::vector<uint32_t> first_;
  std::vector<uint64_t> starts_;
  std::vector<Edge> edges_;
};

bool Allows(const knot::MoveRules& rules, EdgeKind kind);

/// How many of each there are.
struct MoveGraphCounts {
  struct Edges {
    uint64_t moves = 0, pairs = 0;
  };
  std::vector<uint64_t> nodes, self_equivalent;      // by intersections
  std::vector<std::array<Edges, kEdgeKinds>> edges;  // by intersections of the smaller P-data
  std::map<uint32_t, uint64_t> pairs_by_kinds;       // by the set of kinds that join a pair, 1 << kind
  uint64_t pairs_with_several_moves = 0;             // of one kind or of several
  std::vector<std::vector<uint64_t>> at_distance;    // by intersections and steps from the straight rope
  uint64_t classes = 0;                              // without Cross moves
  uint64_t class_brackets = 0;                       // different normalized brackets among them
  std::vector<uint64_t> of_the_straight_rope;        // nodes of its class, by intersections
  std::vector<uint64_t> with_its_bracket;            // nodes whose bracket is 1, by intersections
};

MoveGraphCounts CountMoveGraph(const MoveGraph& graph);

}  // namespace tact::enumerators

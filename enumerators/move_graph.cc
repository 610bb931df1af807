#include "enumerators/move_graph.h"

#include <algorithm>
#include <numeric>

#include "algebra/error.h"
#include "algebra/knot/tying_search.h"
#include "enumerators/planar_p_data.h"

namespace tact::enumerators {
namespace {

using knot::Move;
using knot::MoveKind;
using knot::PData;
using knot::RopeEnd;

EdgeKind KindOf(const Move& move) {
  switch (move.kind) {
    case MoveKind::kR1:
      return EdgeKind::kR1;
    case MoveKind::kR2:
      return EdgeKind::kR2;
    case MoveKind::kR3:
      return EdgeKind::kR3;
    case MoveKind::kCross:
      break;
  }
  return move.end == RopeEnd::kSelective ? EdgeKind::kCrossSelective : EdgeKind::kCrossOther;
}

uint32_t Root(std::vector<uint32_t>& parent, uint32_t a) {
  while (parent[a] != a) a = parent[a] = parent[parent[a]];
  return a;
}

}  // namespace

const char* ToString(EdgeKind kind) {
  constexpr const char* kNames[] = {"R1", "R2", "R3", "Cross selective", "Cross other"};
  return kNames[static_cast<size_t>(kind)];
}

bool Allows(const knot::MoveRules& rules, EdgeKind kind) {
  switch (kind) {
    case EdgeKind::kR1:
      return rules.r1;
    case EdgeKind::kR2:
      return rules.r2;
    case EdgeKind::kR3:
      return rules.r3;
    case EdgeKind::kCrossSelective:
      return rules.cross && rules.held != RopeEnd::kSelective;
    case EdgeKind::kCrossOther:
      return rules.cross && rules.held != RopeEnd::kOther;
  }
  return false;
}

MoveGraph::MoveGraph(int most_crossings) {
  if (most_crossings < 0 || most_crossings > kMostCrossings) {
    throw PreconditionError("MoveGraph: expected 0 to " + std::to_string(kMostCrossings) +
                            " intersections, got " + std::to_string(most_crossings));
  }
  for (int n = 0; n <= most_crossings; ++n) {
    first_.push_back(static_cast<uint32_t>(store_.size()));
    ForEachPlanarPData(n, [&](const PData& p) { store_.Insert(p); });
  }
  first_.push_back(static_cast<uint32_t>(store_.size()));
  starts_.reserve(store_.size() + 1);
  for (uint32_t node = 0; node < nodes(); ++node) {
    starts_.push_back(edges_.size());
    const PData p = store_.Get(node);
    for (const Move& move : AllMoves(p, 0)) {
      edges_.push_back({store_.Find(ApplyFound(p, move)) & 0x1fffffffu, static_cast<uint32_t>(KindOf(move))});
    }
    std::sort(edges_.begin() + static_cast<std::ptrdiff_t>(starts_.back()), edges_.end(),
              [](Edge a, Edge b) { return a.to != b.to ? a.to < b.to : a.kind < b.kind; });
  }
  starts_.push_back(edges_.size());
}

int MoveGraph::CrossingsOf(uint32_t node) const {
  return static_cast<int>(std::upper_bound(first_.begin(), first_.end(), node) - first_.begin()) - 1;
}

std::vector<uint8_t> MoveGraph::Distances(const knot::MoveRules& rules) const {
  std::vector<uint8_t> distance(nodes(), kUnreached);
  distance[0] = 0;
  // Edges are kept at one of their nodes: sweep until nothing gets nearer. Every sweep settles one step more at least.
  for (bool nearer = true; nearer;) {
    nearer = false;
    for (uint32_t node = 0; node < nodes(); ++node) {
      for (const Edge* e = begin(node); e != end(node); ++e) {
        if (!Allows(rules, static_cast<EdgeKind>(e->kind))) continue;
        uint8_t &a = distance[node], &b = distance[e->to];
        if (a != kUnreached && a + 1 < b) b = static_cast<uint8_t>(a + 1), nearer = true;
        if (b != kUnreached && b + 1 < a) a = static_cast<uint8_t>(b + 1), nearer = true;
      }
    }
  }
  return distance;
}

std::vector<uint32_t> MoveGraph::Classes(const knot::MoveRules& rules, int bound) const {
  std::vector<uint32_t> parent(first(std::min(bound, most_crossings()) + 1));
  std::iota(parent.begin(), parent.end(), 0u);
  for (uint32_t node = 0; node < parent.size(); ++node) {
    for (const Edge* e = begin(node); e != end(node); ++e) {
      if (!Allows(rules, static_cast<EdgeKind>(e->kind))) continue;
      const uint32_t a = Root(parent, node), b = Root(parent, e->to);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (uint32_t node = 0; node < parent.size(); ++node) parent[node] = Root(parent, node);
  return parent;
}

}  // namespace tact::enumerators

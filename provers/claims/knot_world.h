/// @file
/// How far the claims about moves go, their random ropes, and words that they share.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"
#include "enumerators/planar_p_data.h"
#include "provers/ledger.h"

namespace tact::provers {

using enumerators::ForEachPlanarPData;
using enumerators::ForEachPlanarPDataTo;

/// How far the claims about moves go, in intersections: before a move that adds, after it, of an R3 and what else its rule may
/// accept, of an R3 alone.
struct KnotBounds {
  int smaller = 0, larger = 0, equal = 0, triangle = 0;
};
inline KnotBounds BoundsOf(Effort effort) {
  if (effort == Effort::kQuick) return {2, 3, 3, 3};
  if (effort == Effort::kStandard) return {3, 5, 4, 4};
  return {5, 6, 5, 6};
}
/// "all P-data of up to 3 intersections"
inline std::string AllPData(int crossings) {
  return "all P-data of up to " + std::to_string(crossings) + " intersections";
}

/// "(4 5 6 1 2 3; 3 4 3 4 3 4)", mates and attributes; "the straight rope".
inline std::string Show(const knot::PData& p) {
  if (p.columns() == 0) return "the straight rope";
  const auto row = [](const std::vector<int>& numbers) {
    std::string text;
    for (const int n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
    return text;
  };
  return "(" + row(p.SigmaRow()) + "; " + row(p.AttrRow()) + ")";
}

/// Whether the move, which adds or shifts, is possible by the faces of p and gives q.
inline bool Realises(const knot::PData& p, const knot::Move& move, const knot::PData& q) {
  return !FindMoveFault(p, move) && Apply(p, move) == q;
}

/// A rope of so many intersections by random moves that add.
inline knot::PData RandomRope(std::mt19937_64& random, int crossings) {
  knot::PData p;
  while (p.crossings() < crossings) {
    auto moves = AllMoves(p, crossings);
    const bool cross = random() % 4 != 0;
    std::erase_if(moves, [&](const knot::Move& m) {
      return m.direction != knot::MoveDirection::kAdd || (cross && m.kind != knot::MoveKind::kCross);
    });
    p = Apply(p, moves[random() % moves.size()]);
  }
  return p;
}
/// Visits some random ropes of 6 to 12 intersections.
template <typename Visit>
void ForEachRandomRope(Effort effort, const Visit& visit) {
  std::mt19937_64 random(20060329);
  const int ropes = effort == Effort::kQuick ? 7 : effort == Effort::kStandard ? 70 : 3500;
  for (int k = 0; k < ropes; ++k) visit(RandomRope(random, 6 + k % 7));
}
/// Visits all their moves.
template <typename Visit>
void ForEachRandomMove(Effort effort, const Visit& visit) {
  ForEachRandomRope(effort, [&](const knot::PData& p) {
    for (const knot::Move& move : AllMoves(p)) visit(p, move);
  });
}

/// What one pass through a world finds, kept for all claims that ask for it.
template <auto kFind>
const auto& KeptFor(Effort effort) {
  if (effort == Effort::kQuick) {
    static const auto quick = kFind(Effort::kQuick);
    return quick;
  }
  if (effort == Effort::kStandard) {
    static const auto standard = kFind(Effort::kStandard);
    return standard;
  }
  static const auto full = kFind(Effort::kFull);
  return full;
}

/// The least pair of P-data: the first by fewer columns, then by order; with what belongs to it.
template <typename More>
struct LeastPair {
  bool found = false;
  knot::PData before, after;
  More more{};

  void Offer(const knot::PData& p, const knot::PData& q, const More& with) {
    if (found && std::pair(before, after) <= std::pair(p, q)) return;
    found = true;
    before = p;
    after = q;
    more = with;
  }
};

}  // namespace tact::provers

/// @file
/// What comes of trying a rule that detects a kind of move: moves it misses, conclusions that are wrong.
/// Model   Complete: every move that the faces admit is found, with its segments, from the pair that it makes. Sound:
///         every conclusion is such a move.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "provers/claims/knot_world.h"

namespace tact::provers {

struct RuleTrial {
  long long moves = 0, missed = 0;                // of all P-data to the bound
  long long random_moves = 0, random_missed = 0;  // of random ropes
  long long conclusions = 0, wrong = 0;           // of both
  LeastPair<knot::Move> least_missed;             // of all P-data to the bound, as the next
  LeastPair<std::vector<int>> least_wrong;        // segments; no move of the kind leads from one to the other

  bool complete() const { return moves > 0 && missed + random_missed == 0; }
  bool sound() const { return wrong == 0; }
};

/// The six counts, named for the ledger.
inline std::vector<std::pair<std::string, long long>> Numbers(const RuleTrial& trial) {
  return {{"moves from the faces", trial.moves},
          {"moves missed", trial.missed},
          {"moves of random ropes", trial.random_moves},
          {"of these missed", trial.random_missed},
          {"conclusions", trial.conclusions},
          {"conclusions without such a move", trial.wrong}};
}

/// Whether a move of the kind adds intersections.
inline bool Adds(const knot::Move& move, knot::MoveKind kind) {
  return move.kind == kind && move.direction == knot::MoveDirection::kAdd;
}

/// Tries whether the rule finds every move of the kind that adds: finds(before, move, after).
template <typename Finds>
void TryMoves(RuleTrial& trial, knot::MoveKind kind, Effort effort, const Finds& finds) {
  const int more = kind == knot::MoveKind::kR2 ? 2 : 1;  // intersections
  ForEachPlanarPDataTo(BoundsOf(effort).smaller, [&](const knot::PData& p) {
    for (const knot::Move& move : AllMoves(p, p.crossings() + more)) {
      if (!Adds(move, kind)) continue;
      ++trial.moves;
      const knot::PData q = Apply(p, move);
      if (finds(p, move, q)) continue;
      ++trial.missed;
      trial.least_missed.Offer(p, q, move);
    }
  });
  ForEachRandomMove(effort, [&](const knot::PData& p, const knot::Move& move) {
    if (!Adds(move, kind)) return;
    ++trial.random_moves;
    trial.random_missed += finds(p, move, Apply(p, move)) ? 0 : 1;
  });
}

/// Tries everything that the rule concludes about the P-data after a move: conclude(after) adds it to the trial.
template <typename Conclude>
void TryConclusions(RuleTrial& trial, Effort effort, const Conclude& conclude) {
  ForEachPlanarPDataTo(BoundsOf(effort).larger, conclude);
  const auto least = trial.least_wrong;  // a random pair is not the least of its kind
  ForEachRandomRope(effort, conclude);
  trial.least_wrong = least;
}

/// "every R2 from all P-data of up to 3 ...": what TryMoves and TryConclusions go through.
inline std::string RuleBound(const std::string& moves, Effort effort) {
  return "every " + moves + " from " + AllPData(BoundsOf(effort).smaller) + "; every conclusion about " +
         AllPData(BoundsOf(effort).larger) + "; both for random ropes of 6 to 12";
}

}  // namespace tact::provers

/// @file
/// A shortest sequence of movement primitives that ties a knot from the straight rope.
/// Model   A best-first search from the knot toward the straight rope (moves lead both ways), level by level in the length
///         that a sequence through a P-data has at least (tying_bound.h). Two P-data are one state just if they are equal as
///         read off from the same end: while a rope is tied its ends keep their names. A level that is searched to its end
///         excludes its length, whatever the number of intersections on the way: the bound grows with them.
/// Method  The search is A* with a consistent bound, each state opened in part: only by moves that keep to the level
///         [Hart et al. 1968].
/// Errors  PreconditionError: a knot that no sphere holds. BudgetError: nothing was found or excluded for good within the budget.
#pragma once

#include <climits>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "algebra/knot/move.h"

namespace tact::knot {

/// Which moves may be used.
struct MoveRules {
  bool r1 = true, r2 = true, r3 = true, cross = true;
  RopeEnd held = RopeEnd::kNone;  // the end that crosses nothing

  bool Allow(const Move& move) const {
    switch (move.kind) {
      case MoveKind::kR1:
        return r1;
      case MoveKind::kR2:
        return r2;
      case MoveKind::kR3:
        return r3;
      case MoveKind::kCross:
        return cross && move.end != held;
    }
    return false;
  }
  /// Whether intersections can come and go one at a time.
  bool single() const { return r1 || cross; }
};

struct TyingOptions {
  MoveRules rules;
  int limit = INT_MAX;              // steps at most
  size_t most_states = 3'000'000;   // P-data kept
  size_t most_bytes = 200'000'000;  // what they take, about; while they grow, twice that
  /// Told now and then: the length that is on trial, and how many P-data are kept.
  std::function<void(int length, size_t states)> progress = {};
};

struct TyingStep {
  Move move;
  PData reached;
};

struct Tying {
  bool found = false;
  std::vector<TyingStep> steps;  // from the straight rope, the last one reaching the knot
  int excluded_below = 0;        // every sequence is at least so long; if not found, because of the limit
  std::string impossible;        // why there is no sequence of any length; empty if that is not known
  size_t states = 0;             // P-data that the search kept

  bool proved_shortest() const { return found && excluded_below == static_cast<int>(steps.size()); }
};

/// Found, with the length proved shortest or, if the budget ended first, not; or not found because it is impossible or every
/// sequence is longer than the limit.
Tying TieShortest(const PData& knot, const TyingOptions& options = {});

}  // namespace tact::knot

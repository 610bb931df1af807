#include "algebra/knot/tying.h"

#include <algorithm>

#include "algebra/error.h"
#include "algebra/knot/bracket.h"
#include "algebra/knot/faces.h"
#include "algebra/knot/tying_bound.h"
#include "algebra/knot/tying_search.h"

namespace tact::knot {
namespace {

// Above this many intersections the bracket polynomial takes too long to try first.
constexpr int kMostBracketCrossings = 14;

std::string WhyImpossible(const PData& knot, const MoveRules& rules, const TyingBound& bound) {
  if (!bound.possible()) {
    return rules.r2 ? "without R1 and Cross the signs of intersections never add up to anything but 0"
                    : "the allowed moves leave the straight rope as it is";
  }
  if (rules.cross || knot.crossings() > kMostBracketCrossings) return "";
  if (NormalizedBracket(knot) == OneBracket()) return "";
  return "Reidemeister moves keep the rope's normalized bracket polynomial, and it is not the straight "
         "rope's";
}

// Undoes the knot without looking ahead: an R2 if there is one, else the first other removal. Not found if that ends early.
Tying TieGreedily(const PData& knot, const MoveRules& rules) {
  std::vector<PData> states = {knot};
  std::vector<Move> undoing, moves;
  while (states.back().columns() > 0) {
    ListRemovals(states.back(), rules, moves);
    if (moves.empty()) return {};
    undoing.push_back(moves.front());
    states.push_back(ApplyFound(states.back(), moves.front()));
  }
  Tying tying;
  tying.found = true;
  tying.steps = TurnRound(std::move(states), undoing);
  return tying;
}

// A shortest sequence whose steps never take an intersection away, or what is known of it within the budget.
Tying TieWithoutDetours(const PData& knot, const TyingOptions& options, int bound) {
  Tying tying = TieGreedily(knot, options.rules);
  TyingSearch search(knot, options, false, options.most_states / 8);
  for (int length = bound; length <= options.limit && !search.exhausted(); ++length) {
    if (tying.found && length >= static_cast<int>(tying.steps.size())) break;
    if (search.SearchLevel()) {
      tying.found = true;
      tying.steps = search.Steps();
      break;
    }
    if (search.spent()) break;
  }
  return tying;
}

}  // namespace

Tying TieShortest(const PData& knot, const TyingOptions& options) {
  if (!IsPlanar(knot)) {
    throw PreconditionError("TieShortest: expected P-data of a sphere, got genus " +
                            std::to_string(Genus(knot)));
  }
  const TyingBound bound(knot, options.rules);
  Tying tying;
  tying.impossible = WhyImpossible(knot, options.rules, bound);
  if (!tying.impossible.empty()) return tying;

  tying = TieWithoutDetours(knot, options, bound.steps());
  tying.excluded_below = bound.steps();
  const int most = tying.found ? static_cast<int>(tying.steps.size()) : INT_MAX;
  TyingSearch search(knot, options, true, options.most_states);
  for (; tying.excluded_below < most && tying.excluded_below <= options.limit; ++tying.excluded_below) {
    if (options.progress) options.progress(tying.excluded_below, search.states());
    const bool reached = search.SearchLevel();
    tying.states = search.states();
    if (reached) {
      tying.found = true;
      tying.steps = search.Steps();
      break;
    }
    if (search.spent()) {
      if (tying.found) break;
      throw BudgetError("tying: " + std::to_string(search.states()) + " P-data were searched; fewer than " +
                        std::to_string(tying.excluded_below) + " steps are excluded, nothing more is known");
    }
  }
  if (static_cast<int>(tying.steps.size()) > options.limit) {
    tying.found = false;
    tying.steps.clear();
  }
  return tying;
}

}  // namespace tact::knot

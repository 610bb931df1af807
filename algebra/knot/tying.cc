#include "algebra/knot/tying.h"

#include <algorithm>

#include "algebra/error.h"
#include "algebra/knot/bracket.h"
#include "algebra/knot/move_sites.h"
#include "algebra/knot/p_data_store.h"
#include "algebra/knot/tying_bound.h"

namespace tact::knot {
namespace {

// Above this many intersections the bracket polynomial takes too long to try first.
constexpr int kMostBracketCrossings = 14;

// Apply without its check, for moves that were read off from p.
PData ApplyFound(const PData& p, const Move& move) {
  if (move.direction == MoveDirection::kShift) return Apply(p, move);
  const bool add = move.direction == MoveDirection::kAdd;
  const int taken = add ? 0 : move.kind == MoveKind::kR2 ? 4 : 2;
  const AddedColumns added = ColumnsOf(move, p.columns() - taken);
  const auto& c = added.columns;
  if (added.count == 2) {
    return add ? InsertColumns(p, added.to, {c[0], c[1]}) : RemoveColumns(p, {c[0].column, c[1].column});
  }
  return add ? InsertColumns(p, added.to, {c[0], c[1], c[2], c[3]})
             : RemoveColumns(p, {c[0].column, c[1].column, c[2].column, c[3].column});
}

// The moves that take intersections away: R2, R1, then Cross of the other end and of the selective one.
void ListRemovals(const PData& p, const MoveRules& rules, std::vector<Move>& moves) {
  moves.clear();
  const int n = p.columns();
  if (n == 0) return;
  const auto add = [&](const Move& move) {
    if (rules.Allow(move)) moves.push_back(move);
  };
  for (int i = 1; rules.r2 && i < n; ++i) {
    if (const auto move = R2RemovalAt(p, i)) add(*move);
  }
  const auto remove = MoveDirection::kRemove;
  for (int i = 1; i < n; ++i) {
    if (p.sigma(i) == i + 1) add({MoveKind::kR1, remove, {i, 0, 0}, {}, p.attr(i)});
  }
  add({MoveKind::kCross, remove, {p.sigma(n), 0, 0}, RopeEnd::kOther, p.attr(n)});
  add({MoveKind::kCross, remove, {p.sigma(1) - 1, 0, 0}, RopeEnd::kSelective, p.attr(1)});
}

// Steps that undo the knot, turned into steps that tie it: states[k] is reached by undoing[k - 1].
std::vector<TyingStep> TurnRound(const std::vector<PData>& states, const std::vector<Move>& undoing) {
  std::vector<TyingStep> steps;
  for (size_t k = undoing.size(); k-- > 0;) steps.push_back({Inverse(undoing[k]), states[k]});
  return steps;
}

// Undoes the knot without looking ahead: an R2 if there is one, else the first other removal. Empty if that ends early.
std::vector<TyingStep> TieGreedily(const PData& knot, const MoveRules& rules) {
  std::vector<PData> states = {knot};
  std::vector<Move> undoing, moves;
  while (states.back().columns() > 0) {
    ListRemovals(states.back(), rules, moves);
    if (moves.empty()) return {};
    undoing.push_back(moves.front());
    states.push_back(ApplyFound(states.back(), moves.front()));
  }
  return TurnRound(states, undoing);
}

class Search {
 public:
  Search(const PData& knot, const TyingOptions& options) : options_(options) {
    store_.Insert(knot);
    came_.push_back(0);
  }

  // Searches all P-data through which a sequence of `length` steps can lead, and no fewer: the levels from the bound up, each
  // once. Whether the straight rope is among them.
  bool SearchLevel() {
    const size_t level = levels_.size();
    levels_.emplace_back();
    if (level == 0) open_ = {0};
    if (Drain()) return true;
    for (const size_t detour : {size_t{1}, size_t{2}}) {
      if (level < detour) break;
      for (size_t k = 0; k < levels_[level - detour].size(); ++k) {
        if (Open(levels_[level - detour][k], static_cast<int>(detour)) || Drain()) return true;
        if (spent()) return false;
      }
    }
    return false;
  }

  bool spent() const {
    return store_.size() > options_.most_states || store_.bytes() + 12 * store_.size() > options_.most_bytes;
  }
  size_t states() const { return store_.size(); }

  std::vector<TyingStep> Steps() const {
    std::vector<PData> states = {PData()};
    std::vector<Move> undoing;
    for (uint32_t at = store_.Find(PData()); at != 0; at = came_[at]) {
      states.push_back(store_.Get(came_[at]));
      undoing.push_back(MoveBetween(states.back(), states[states.size() - 2]));
    }
    std::reverse(undoing.begin(), undoing.end());
    std::reverse(states.begin(), states.end());
    return TurnRound(states, undoing);
  }

 private:
  // The move between neighbours of a sequence is found again: it takes no memory meanwhile.
  Move MoveBetween(const PData& p, const PData& q) const {
    for (const Move& move : DetectMoves(p, q)) {
      if (options_.rules.Allow(move)) return move;
    }
    throw InvariantError("tying: no move between two P-data of the sequence");
  }

  // Opens what is open by moves without a detour, the latest first.
  bool Drain() {
    while (!open_.empty()) {
      if (spent()) return false;
      const uint32_t state = open_.back();
      open_.pop_back();
      levels_.back().push_back(state);
      if (Open(state, 0)) return true;
    }
    return false;
  }

  // Adds what moves of that detour lead to; true if it is the straight rope.
  bool Open(uint32_t state, int detour) {
    const PData p = store_.Get(state);
    if (p.columns() == 0) return true;
    const TyingBound bound(p, options_.rules);
    if (detour == 0) {
      ListRemovals(p, options_.rules, moves_);
    } else {
      // A detour of one is no R2.
      moves_ = AllMoves(p, p.crossings() + (detour == 2 && options_.rules.r2 ? 2 : 1));
    }
    for (const Move& move : moves_) {
      if (!options_.rules.Allow(move) || bound.Detour(move) != detour) continue;
      const PData q = ApplyFound(p, move);
      const auto [number, is_new] = store_.Insert(q);
      if (!is_new) continue;
      came_.push_back(state);
      if (q.columns() == 0) return true;
      open_.push_back(number);
    }
    return false;
  }

  const TyingOptions& options_;
  PDataStore store_;
  std::vector<uint32_t> came_;                 // from which state
  std::vector<std::vector<uint32_t>> levels_;  // by what their least length exceeds the knot's bound
  std::vector<uint32_t> open_;
  std::vector<Move> moves_;
};

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

}  // namespace

Tying TieShortest(const PData& knot, const TyingOptions& options) {
  if (!IsPlanar(knot))
    throw PreconditionError("TieShortest: expected P-data of a sphere, got genus " +
                            std::to_string(Genus(knot)));
  const TyingBound bound(knot, options.rules);
  Tying tying;
  tying.impossible = WhyImpossible(knot, options.rules, bound);
  if (!tying.impossible.empty()) return tying;
  tying.excluded_below = bound.steps();
  const std::vector<TyingStep> greedy = TieGreedily(knot, options.rules);
  const bool bounded = knot.columns() == 0 || !greedy.empty();
  const int most = bounded ? static_cast<int>(greedy.size()) : INT_MAX;

  Search search(knot, options);
  for (; tying.excluded_below < most && tying.excluded_below <= options.limit; ++tying.excluded_below) {
    if (options.progress) options.progress(tying.excluded_below, search.states());
    tying.found = search.SearchLevel();
    tying.states = search.states();
    if (tying.found) {
      tying.steps = search.Steps();
      return tying;
    }
    if (search.spent()) break;
  }
  if (bounded && most <= options.limit) {
    tying.found = true;
    tying.steps = greedy;
  } else if (tying.excluded_below <= options.limit) {
    throw BudgetError("tying: " + std::to_string(search.states()) + " P-data were searched; fewer than " +
                      std::to_string(tying.excluded_below) + " steps are excluded, nothing more is known");
  }
  return tying;
}

}  // namespace tact::knot

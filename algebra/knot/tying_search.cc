#include "algebra/knot/tying_search.h"

#include <algorithm>

#include "algebra/error.h"
#include "algebra/knot/move_sites.h"
#include "algebra/knot/tying_bound.h"

namespace tact::knot {

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

std::vector<TyingStep> TurnRound(std::vector<PData> states, const std::vector<Move>& undoing) {
  std::vector<TyingStep> steps;
  for (size_t k = undoing.size(); k-- > 0;) steps.push_back({Inverse(undoing[k]), std::move(states[k])});
  return steps;
}

TyingSearch::TyingSearch(const PData& knot, const TyingOptions& options, bool additions, size_t most_states)
    : options_(options), additions_(additions), most_states_(most_states) {
  store_.Insert(knot);
  came_.push_back(0);
}

bool TyingSearch::SearchLevel() {
  const size_t level = levels_.size();
  levels_.emplace_back();
  if (level == 0) open_ = {0};
  if (Drain()) return true;
  for (const size_t detour : {size_t{1}, size_t{2}}) {
    if (level < detour) break;
    for (size_t k = 0; k < levels_[level - detour].size() && !spent(); ++k) {
      if (Open(levels_[level - detour][k], static_cast<int>(detour)) || Drain()) return true;
    }
  }
  return false;
}

bool TyingSearch::exhausted() const {
  const size_t count = levels_.size();
  return !spent() && count >= 2 && levels_[count - 1].empty() && levels_[count - 2].empty();
}

std::vector<TyingStep> TyingSearch::Steps() const {
  std::vector<PData> states = {PData()};
  std::vector<Move> undoing;
  for (uint32_t at = store_.Find(PData()); at != 0; at = came_[at]) {
    states.push_back(store_.Get(came_[at]));
    undoing.push_back(MoveBetween(states.back(), states[states.size() - 2]));
  }
  std::reverse(undoing.begin(), undoing.end());
  std::reverse(states.begin(), states.end());
  return TurnRound(std::move(states), undoing);
}

// Moves of the sequence are found again: the search keeps none.
Move TyingSearch::MoveBetween(const PData& p, const PData& q) const {
  for (const Move& move : DetectMoves(p, q)) {
    if (options_.rules.Allow(move)) return move;
  }
  throw InvariantError("tying: no move between two P-data of the sequence");
}

// Opens what is open by moves without a detour, the latest first.
bool TyingSearch::Drain() {
  while (!open_.empty() && !spent()) {
    const uint32_t state = open_.back();
    open_.pop_back();
    levels_.back().push_back(state);
    if (Open(state, 0)) return true;
  }
  return false;
}

// Adds what moves of that detour lead to; true if it is the straight rope.
bool TyingSearch::Open(uint32_t state, int detour) {
  const PData p = store_.Get(state);
  if (p.columns() == 0) return true;
  const TyingBound bound(p, options_.rules);
  if (detour == 0) {
    ListRemovals(p, options_.rules, moves_);
  } else {
    // The addition of an R2 is a detour of two.
    const int more = !additions_ ? 0 : detour == 2 && options_.rules.r2 ? 2 : 1;
    moves_ = AllMoves(p, more == 0 ? 0 : p.crossings() + more);
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

}  // namespace tact::knot

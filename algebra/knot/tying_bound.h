/// @file
/// How many moves it takes at least to undo a knot: what no move changes by more than one.
/// Model   Sort the intersections by sign and by which strand is met first, the upper or the lower. With c intersections, let
///         u be (number +) - (number -) among those first met above, v the same among those first met below. R1 and Cross change c by
///         one and one of u, v by one; an R2 changes c by two and neither u nor v, its two intersections having one strand first
///         and both signs; an R3 changes nothing. So b = (c + |u| + |v|) / 2, a whole number, changes by at most one, and it
///         is 0 for the straight rope. Without R2 b = c; without R1 and Cross b = c / 2, and u or v not 0 cannot be undone.
#pragma once

#include <cstdlib>

#include "algebra/knot/tying.h"

namespace tact::knot {

class TyingBound {
 public:
  TyingBound(const PData& p, const MoveRules& rules) : rules_(rules), crossings_(p.crossings()) {
    for (int i = 1; i <= p.columns(); ++i) {
      if (p.sigma(i) > i) (p.over(i) ? over_ : under_) += p.sign(i);
    }
  }

  bool possible() const {
    if (crossings_ == 0) return true;
    return rules_.single() || (rules_.r2 && over_ == 0 && under_ == 0);
  }
  /// If possible.
  int steps() const { return Steps(crossings_, over_, under_); }

  /// One more than what the move adds to the bound: 0, 1 or 2. By so much it makes the least length of a sequence longer.
  int Detour(const Move& move) const {
    if (move.direction == MoveDirection::kShift) return 1;
    const int way = move.direction == MoveDirection::kAdd ? 1 : -1;
    if (move.kind == MoveKind::kR2) return 1 + way;
    const bool last = move.kind == MoveKind::kCross && move.end == RopeEnd::kOther;
    const bool over = (move.attr % 2 == 1) != last;
    const int sign = (move.attr > 2 ? 1 : -1) * way;
    return 1 + Steps(crossings_ + way, over_ + (over ? sign : 0), under_ + (over ? 0 : sign)) - steps();
  }

 private:
  int Steps(int c, int u, int v) const {
    if (!rules_.r2) return c;
    return (c + std::abs(u) + std::abs(v)) / 2;
  }

  const MoveRules& rules_;
  int crossings_ = 0, over_ = 0, under_ = 0;
};

}  // namespace tact::knot

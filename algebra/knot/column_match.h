/// @file
/// How many columns of a P-data disagree with another one that has columns more, as the places of the new columns change: the
/// verdict on one candidate for a move is carried to the next through the columns between them.
/// Cost    O(n) for the first place; then O(distance) for each change of a place, at most O(n).
#pragma once

#include <algorithm>

#include "algebra/knot/columns.h"

namespace tact::knot {

class ColumnMatch {
 public:
  ColumnMatch(const PData& a, const PData& b) : a_(a), b_(b) {}

  /// Whether b without the new columns is a; the last place asked for is the start of the next question.
  /// Precondition: as many new columns each time, and b has so many more than a.
  bool EqualAt(const Renumbering& to) {
    const bool near = Distance(to_.first, to.first) + Distance(to_.second, to.second) <= a_.columns() / 2;
    if (mismatches_ < 0 || !near) {
      to_ = to;
      Count();
    } else {
      Move(to_.first, to.first);
      Move(to_.second, to.second);
    }
    return mismatches_ == 0;
  }

 private:
  static int Distance(int from, int to) { return from < to ? to - from : from - to; }

  bool Matches(int column) const {
    const int there = to_(column);
    return b_.attr(there) == a_.attr(column) && b_.sigma(there) == to_(a_.sigma(column));
  }

  void Count() {
    mismatches_ = 0;
    for (int i = 1; i <= a_.columns(); ++i) mismatches_ += Matches(i) ? 0 : 1;
  }

  // Only columns between the two places, and their mates, go elsewhere.
  void Move(int& place, int target) {
    if (place == target) return;
    const int low = std::min(place, target), high = std::max(place, target);
    const auto count = [&] {
      int among = 0;
      for (int i = low; i < high; ++i) {
        among += Matches(i) ? 0 : 1;
        const int mate = a_.sigma(i);
        if (mate < low || mate >= high) among += Matches(mate) ? 0 : 1;
      }
      return among;
    };
    mismatches_ -= count();
    place = target;
    mismatches_ += count();
  }

  const PData& a_;
  const PData& b_;
  Renumbering to_;
  int mismatches_ = -1;  // not counted yet
};

}  // namespace tact::knot

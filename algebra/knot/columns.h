/// @file
/// Columns put into P-data and taken out of it, the others renumbered: what all moves are made of.
/// Cost    O(n) each.
#pragma once

#include <initializer_list>
#include <limits>

#include "algebra/knot/p_data.h"

namespace tact::knot {

/// Where the old columns go: `first_count` new columns come before column `first`, `second_count` before `second`.
struct Renumbering {
  int first = std::numeric_limits<int>::max(), first_count = 0;
  int second = std::numeric_limits<int>::max(), second_count = 0;

  int operator()(int column) const {
    return column + (column >= first ? first_count : 0) + (column >= second ? second_count : 0);
  }
};

struct NewColumn {
  int column = 0;  // its number after insertion
  int sigma = 0, attr = 0;
};

/// p with more columns. Precondition: `added` ascends and fills the gaps that `to` leaves.
PData InsertColumns(const PData& p, const Renumbering& to, std::initializer_list<NewColumn> added);

/// p without the columns. Precondition: they ascend, and each one's mate is among them.
PData RemoveColumns(const PData& p, std::initializer_list<int> removed);

/// Whether p with columns inserted so is q, new columns apart.
inline bool EqualBut(const PData& p, const Renumbering& to, const PData& q) {
  for (int i = 1; i <= p.columns(); ++i) {
    if (q.sigma(to(i)) != to(p.sigma(i)) || q.attr(to(i)) != p.attr(i)) return false;
  }
  return true;
}

}  // namespace tact::knot

/// @file
/// Whether { x | E x = 0, A x > 0, B x >= 0 } has a point: the slow obvious algorithm, for tests only.
/// Model   Equalities are solved for a variable, strict and weak inequalities eliminated pairwise [Fourier,
/// Motzkin].
#pragma once

#include <set>
#include <vector>

#include "algebra/exact/rational.h"

namespace tact::algebra {

using RationalRow = std::vector<Rational>;

class FourierMotzkin {
 public:
  void Equal(RationalRow row) { equalities_.push_back(std::move(row)); }
  void Positive(RationalRow row) { Add(inequalities_, std::move(row), true); }
  void NonNegative(RationalRow row) { Add(inequalities_, std::move(row), false); }

  bool Feasible(size_t dimension) {
    for (size_t e = 0; e < equalities_.size(); ++e) {
      const RationalRow pivot_row = equalities_[e];
      size_t column = 0;
      while (column < dimension && pivot_row[column].sign() == 0) ++column;
      if (column == dimension) continue;
      const auto clear = [&](RationalRow& row) {
        const Rational factor = row[column] / pivot_row[column];
        for (size_t j = 0; j < dimension; ++j) row[j] -= factor * pivot_row[j];
      };
      for (size_t later = e + 1; later < equalities_.size(); ++later) clear(equalities_[later]);
      std::set<Inequality> cleared;
      for (auto [row, strict] : inequalities_) {
        clear(row);
        Add(cleared, std::move(row), strict);
      }
      inequalities_.swap(cleared);
    }
    for (size_t column = 0; column < dimension; ++column) Eliminate(column, dimension);
    for (const auto& [row, strict] : inequalities_) {
      if (strict) return false;  // 0 > 0
    }
    return true;
  }

 private:
  using Inequality = std::pair<RationalRow, bool>;

  static void Add(std::set<Inequality>& all, RationalRow row, bool strict) {
    Rational scale;
    for (const Rational& entry : row) {
      if (entry.sign() != 0) {
        scale = Abs(entry);
        break;
      }
    }
    if (scale.sign() != 0) {
      for (Rational& entry : row) entry /= scale;
    }
    all.emplace(std::move(row), strict);
  }

  void Eliminate(size_t column, size_t dimension) {
    std::set<Inequality> next;
    for (const auto& [below, below_strict] : inequalities_) {
      if (below[column].sign() == 0) next.emplace(below, below_strict);
      if (below[column].sign() <= 0) continue;
      for (const auto& [above, above_strict] : inequalities_) {
        if (above[column].sign() >= 0) continue;
        RationalRow sum(dimension);
        for (size_t j = 0; j < dimension; ++j) sum[j] = below[column] * above[j] - above[column] * below[j];
        Add(next, std::move(sum), below_strict || above_strict);
      }
    }
    inequalities_.swap(next);
  }

  std::vector<RationalRow> equalities_;
  std::set<Inequality> inequalities_;
};

}  // namespace tact::algebra

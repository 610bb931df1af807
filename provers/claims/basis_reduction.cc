#include "provers/claims/basis_reduction.h"

#include <algorithm>
#include <optional>

#include "algebra/exact/linear_algebra.h"

namespace tact::provers {
namespace {

using algebra::Integer;
using algebra::IntegerMatrix;

bool IsTranslation(const Screw& s) { return s[0].sign() == 0 && s[1].sign() == 0 && s[2].sign() == 0; }

struct Combination {
  std::vector<size_t> members;
  std::vector<Integer> coefficients;
};

// The relation among the angular parts of the members, if there is exactly one and it needs all of them.
std::optional<Combination> MinimalRelation(const std::vector<Screw>& screws,
                                           const std::vector<size_t>& members) {
  std::vector<algebra::IntegerVector> rows;
  for (int axis = 0; axis < 3; ++axis) {
    rows.emplace_back();
    for (const size_t i : members) rows.back().push_back(screws[i][axis]);
  }
  const IntegerMatrix relations = NullSpace(IntegerMatrix::FromRows(rows, members.size()));
  if (relations.rows != 1) return std::nullopt;
  Combination c{members, relations.RowVector(0)};
  const bool all = std::all_of(c.coefficients.begin(), c.coefficients.end(),
                               [](const Integer& a) { return a.sign() != 0; });
  return all ? std::optional(c) : std::nullopt;
}

// Step 1: the first linearly dependent minimum combination of non-zero angular parts, smallest first. Four
// vectors of three entries always have one.
std::optional<Combination> FindCombination(const std::vector<Screw>& screws) {
  std::vector<size_t> turning;
  for (size_t i = 0; i < screws.size(); ++i) {
    if (!IsTranslation(screws[i])) turning.push_back(i);
  }
  for (size_t size = 2; size <= 4 && size <= turning.size(); ++size) {
    std::vector<char> chosen(turning.size(), 0);
    std::fill(chosen.begin(), chosen.begin() + static_cast<long>(size), 1);
    do {
      std::vector<size_t> members;
      for (size_t i = 0; i < turning.size(); ++i) {
        if (chosen[i] != 0) members.push_back(turning[i]);
      }
      if (auto found = MinimalRelation(screws, members)) return found;
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
  }
  return std::nullopt;
}

}  // namespace

ReducedBasis ReduceBasis(std::vector<Screw> screws, bool remove_last) {
  ReducedBasis result;
  while (const auto c = FindCombination(screws)) {
    Screw sum(6, Integer(0));
    for (size_t k = 0; k < c->members.size(); ++k) {
      for (int j = 0; j < 6; ++j) sum[j] += c->coefficients[k] * screws[c->members[k]][j];
    }
    const size_t gone = remove_last ? c->members.back() : c->members.front();
    screws.erase(screws.begin() + static_cast<long>(gone));
    screws.push_back(sum);
    ++result.rounds;
  }
  result.translations = static_cast<int>(std::count_if(screws.begin(), screws.end(), IsTranslation));
  result.screws = std::move(screws);
  return result;
}

}  // namespace tact::provers

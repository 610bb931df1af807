#include "provers/check/exact_rank.h"

#include <algorithm>
#include <cstddef>

namespace tact::check {
namespace {

struct PivotRow {
  Row row;
  std::size_t column;
};

void Reduce(const PivotRow& pivot, Row& row) {
  const mpz_class factor = row[pivot.column];
  if (factor == 0) return;
  const mpz_class& lead = pivot.row[pivot.column];
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = lead * row[i] - factor * pivot.row[i];
}

}  // namespace

int Rank(const Matrix& matrix) {
  std::vector<PivotRow> pivots;
  for (Row row : matrix) {
    if (pivots.size() == row.size()) break;
    for (const PivotRow& pivot : pivots) Reduce(pivot, row);
    const auto lead = std::find_if(row.begin(), row.end(), [](const mpz_class& entry) { return entry != 0; });
    if (lead == row.end()) continue;
    const auto column = static_cast<std::size_t>(lead - row.begin());
    pivots.push_back({std::move(row), column});
  }
  return static_cast<int>(pivots.size());
}

}  // namespace tact::check

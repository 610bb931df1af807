#include "algebra/cone/complementary_pair.h"

#include <string>

#include "algebra/cone/dual_simplex.h"

namespace tact::algebra {
namespace {

using Steps = std::vector<VanishingStep<Integer>>;

void DivideByCommonFactor(std::vector<Integer>& values) {
  Integer common(0);
  for (const Integer& v : values) common = Gcd(common, v);
  if (common.sign() == 0 || common == Integer(1)) return;
  for (Integer& v : values) v = DivideExactly(v, common);
}

// The smallest K >= 0 with a + K b > 0, for b > 0.
Integer MultiplesToBecomePositive(const Integer& a, const Integer& b) {
  if (a.sign() > 0) return Integer(0);
  mpz_t n, d;
  mpz_init(n);
  mpz_init(d);
  (-a).GetMpz(n);
  b.GetMpz(d);
  mpz_fdiv_q(n, n, d);
  mpz_add_ui(n, n, 1);
  const Integer k = Integer::FromMpz(n);
  mpz_clear(n);
  mpz_clear(d);
  return k;
}

// Adds the step's relation, determinant * a_row - sum_k c_k b_k = 0, and as many copies of the earlier y as
// keep the rows dropped before positive.
void AddStep(const VanishingStep<Integer>& step, int columns, std::vector<Integer>& y) {
  Integer copies(0);
  for (int k = 0; k < columns; ++k) {
    if (!step.dropped_before[k] || step.coefficients[k].sign() <= 0) continue;
    const Integer needed = MultiplesToBecomePositive(-step.coefficients[k], y[step.basis[k]]);
    if (needed > copies) copies = needed;
  }
  if (copies.sign() == 0) copies = Integer(1);
  for (Integer& v : y) v *= copies;
  y[step.row] += step.determinant;
  for (int k = 0; k < columns; ++k) {
    if (step.coefficients[k].sign() != 0) y[step.basis[k]] -= step.coefficients[k];
  }
  DivideByCommonFactor(y);
}

}  // namespace

ComplementaryPair FindComplementaryPair(const std::vector<Integer>& rows, int columns) {
  if (columns < 1 || columns > DualSimplex<Integer>::kMaxColumns || rows.size() % columns != 0) {
    throw PreconditionError("a complementary pair needs rows of 1 to 6 columns");
  }
  const size_t count = rows.size() / columns;
  for (size_t i = 0; i < count; ++i) {
    bool zero = true;
    for (int j = 0; j < columns; ++j) zero = zero && rows[i * columns + j].sign() == 0;
    if (zero) throw PreconditionError("row " + std::to_string(i) + " is zero");
  }
  Steps steps;
  DualSimplex<Integer> simplex;
  simplex.Solve(rows.data(), count, columns, static_cast<size_t>(columns), &steps);
  ComplementaryPair pair;
  const auto x = simplex.interior_point();
  pair.x.assign(x.begin(), x.begin() + columns);
  DivideByCommonFactor(pair.x);
  pair.y.assign(count, Integer(0));
  for (const auto& step : steps) AddStep(step, columns, pair.y);
  return pair;
}

}  // namespace tact::algebra

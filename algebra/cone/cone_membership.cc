#include "algebra/cone/cone.h"
#include "algebra/cone/cone_check.h"
#include "algebra/exact/word.h"

namespace tact::algebra {
namespace {

// Minimises the sum of the artificial variables a in  sum_j weight_j generator_j + a = x,  weights and a >=
// 0, where coordinates with negative x are negated. Variables: rays, then lines, then negated lines, then
// artificial ones. Entries are numerators over the common positive denominator `scale_`, as in fraction-free
// elimination.
template <typename Scalar>
class PhaseOne {
 public:
  PhaseOne(const GeneratorCone& cone, std::span<const Integer> x)
      : n_(x.size()),
        rays_(cone.rays.rows),
        lines_(cone.lines.rows),
        structural_(rays_ + 2 * lines_),
        width_(structural_ + n_ + 1),
        table_((n_ + 1) * width_, Scalar(0)) {
    for (size_t i = 0; i < n_; ++i) {
      const Scalar right = FromInteger<Scalar>(x[i]);
      negated_.push_back(right.sign() < 0);
      for (size_t j = 0; j < rays_; ++j) at(i, j) = Signed(i, FromInteger<Scalar>(cone.rays(j, i)));
      for (size_t j = 0; j < lines_; ++j) {
        at(i, rays_ + j) = Signed(i, FromInteger<Scalar>(cone.lines(j, i)));
        at(i, rays_ + lines_ + j) = -at(i, rays_ + j);
      }
      at(i, structural_ + i) = Scalar(1);
      at(i, width_ - 1) = Signed(i, right);
      basis_.push_back(structural_ + i);
      for (size_t j = 0; j < structural_; ++j) at(n_, j) = at(n_, j) - at(i, j);
      at(n_, width_ - 1) = at(n_, width_ - 1) - at(i, width_ - 1);
    }
  }

  std::variant<Combination, SeparatingNormal> Run() {
    for (size_t entering = Entering(); entering < structural_; entering = Entering()) {
      Pivot(Leaving(entering), entering);
    }
    if (at(n_, width_ - 1).sign() == 0) return Weights();
    return Normal();
  }

 private:
  Scalar& at(size_t i, size_t j) { return table_[i * width_ + j]; }
  Scalar Signed(size_t i, const Scalar& value) const { return negated_[i] ? -value : value; }

  // Bland: the first variable that lowers the sum; structural_ if none does.
  size_t Entering() {
    size_t j = 0;
    while (j < structural_ && at(n_, j).sign() >= 0) ++j;
    return j;
  }

  // Bland: of the rows that reach zero first, the one whose variable comes first. The sum is bounded below,
  // so there is one.
  size_t Leaving(size_t entering) {
    size_t best = n_;
    for (size_t i = 0; i < n_; ++i) {
      if (at(i, entering).sign() <= 0) continue;
      if (best < n_) {
        const Scalar difference =
            at(i, width_ - 1) * at(best, entering) - at(best, width_ - 1) * at(i, entering);
        if (difference.sign() > 0 || (difference.sign() == 0 && basis_[i] > basis_[best])) continue;
      }
      best = i;
    }
    if (best == n_) throw InvariantError("phase one of the simplex method is unbounded");
    return best;
  }

  void Pivot(size_t row, size_t column) {
    const Scalar pivot = at(row, column);
    for (size_t i = 0; i <= n_; ++i) {
      if (i == row) continue;
      const Scalar factor = at(i, column);
      for (size_t j = 0; j < width_; ++j) {
        at(i, j) = MultiplySubtractDivide(pivot, at(i, j), factor, at(row, j), scale_);
      }
    }
    scale_ = pivot;
    basis_[row] = column;
  }

  Combination Weights() {
    Combination result{std::vector<Rational>(lines_), std::vector<Rational>(rays_)};
    for (size_t i = 0; i < n_; ++i) {
      const size_t variable = basis_[i];
      if (variable >= structural_) continue;
      const Rational value(ToInteger(at(i, width_ - 1)), ToInteger(scale_));
      if (variable < rays_) {
        result.ray_weights[variable] = value;
      } else if (variable < rays_ + lines_) {
        result.line_weights[variable - rays_] += value;
      } else {
        result.line_weights[variable - rays_ - lines_] -= value;
      }
    }
    return result;
  }

  // The dual solution y has y . generator <= 0 and y . x the sum, which is positive. An artificial variable's
  // reduced cost is 1 - y_i.
  SeparatingNormal Normal() {
    SeparatingNormal result;
    for (size_t i = 0; i < n_; ++i) {
      result.normal.push_back(ToInteger(Signed(i, at(n_, structural_ + i) - scale_)));
    }
    MakePrimitive(result.normal.data(), n_);
    return result;
  }

  size_t n_, rays_, lines_, structural_, width_;
  std::vector<Scalar> table_;
  std::vector<char> negated_;
  std::vector<size_t> basis_;
  Scalar scale_{1};
};

void RequireVector(size_t expected, size_t got) {
  if (expected == got) return;
  throw PreconditionError("a cone in dimension " + std::to_string(expected) + " and a vector of " +
                          std::to_string(got) + " entries");
}

}  // namespace

std::optional<ViolatedRow> FindViolatedRow(const HalfspaceCone& cone, std::span<const Integer> x) {
  RequireVector(cone.ambient_dimension(), x.size());
  for (size_t i = 0; i < cone.inequalities.rows; ++i) {
    if (Dot(cone.inequalities.row(i), x).sign() < 0) return ViolatedRow{i, false};
  }
  for (size_t i = 0; i < cone.equalities.rows; ++i) {
    if (Dot(cone.equalities.row(i), x).sign() != 0) return ViolatedRow{i, true};
  }
  return std::nullopt;
}

std::variant<Combination, SeparatingNormal> FindCombination(const GeneratorCone& cone,
                                                            std::span<const Integer> x) {
  RequireRows("line", cone.lines, cone.ambient_dimension());
  RequireRows("ray", cone.rays, cone.ambient_dimension());
  RequireVector(cone.ambient_dimension(), x.size());
  return WordsFirst([&]<typename Scalar>(const Scalar&) { return PhaseOne<Scalar>(cone, x).Run(); });
}

}  // namespace tact::algebra

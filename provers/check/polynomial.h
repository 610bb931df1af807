/// @file
/// Polynomials in one variable with integer coefficients, and their sign on 0 <= t < 1.
/// Model   A polynomial is positive on [0, 1) if its Bernstein coefficients there are non-negative and the first
///         is positive; if that does not decide, on both halves of the interval, and so on.
/// Exact   + * = < only.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "provers/check/exact_rank.h"

namespace tact::check {

/// Coefficients of 1, t, t^2, ...; none: zero.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<mpz_class> coefficients) : coefficients_(std::move(coefficients)) {}
  Polynomial(const mpz_class& constant) : coefficients_{constant} {}  // NOLINT: constants convert

  const std::vector<mpz_class>& coefficients() const { return coefficients_; }
  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);

 private:
  std::vector<mpz_class> coefficients_;
};

/// The sign all over 0 <= t < 1, 0 if it is the zero polynomial; nothing if the sign changes, is zero at some
/// t only, or was not decided after some halvings.
std::optional<int> SignOn(const Polynomial& polynomial);

using PolynomialVector = std::array<Polynomial, 3>;
PolynomialVector Cross(const PolynomialVector& a, const PolynomialVector& b);
Polynomial Dot(const PolynomialVector& a, const PolynomialVector& b);
PolynomialVector Constant(const Row& v);

}  // namespace tact::check

/// @file
/// Polynomials of degree at most 2 over the rationals on the interval [0, 1]: roots and signs, exactly.
/// Model   c0 + c1 s + c2 s^2. An irrational root is a + b sqrt(D) with rational a, b, D.
/// Exact   every sign; a sum x + y sqrt(D) is compared with zero by squaring.
/// Errors  PreconditionError: the roots of the zero polynomial.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algebra/exact/rational.h"

namespace tact::algebra {

struct Quadratic {
  Rational c0, c1, c2;

  bool IsZero() const { return c0.sign() == 0 && c1.sign() == 0 && c2.sign() == 0; }
  Rational At(const Rational& s) const { return c0 + s * (c1 + s * c2); }
  /// Coefficients of (1-s)^2, 2 s (1-s), s^2: on [0, 1] the polynomial lies between the least and the largest.
  std::array<Rational, 3> Bernstein() const { return {c0, c0 + Rational(1, 2) * c1, c0 + c1 + c2}; }
  Quadratic operator-() const { return {-c0, -c1, -c2}; }
  friend Quadratic operator+(const Quadratic& a, const Quadratic& b) {
    return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2};
  }
  friend Quadratic operator-(const Quadratic& a, const Quadratic& b) {
    return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2};
  }
  friend Quadratic operator*(const Rational& r, const Quadratic& a) { return {r * a.c0, r * a.c1, r * a.c2}; }
  friend bool operator==(const Quadratic& a, const Quadratic& b) = default;
};

/// center + offset sqrt(radicand). A rational root has offset 0, the others a radicand that is no square.
struct QuadraticRoot {
  Rational center, offset, radicand;

  bool is_rational() const { return offset.sign() == 0; }
  friend bool operator==(const QuadraticRoot& a, const QuadraticRoot& b) = default;
};

/// The sign of center + offset sqrt(radicand).
int SignOf(const QuadraticRoot& number);
/// The sign of the polynomial at the number.
int SignAt(const Quadratic& polynomial, const QuadraticRoot& number);
/// The sign of a - b, for roots with whatever radicands.
int Compare(const QuadraticRoot& a, const QuadraticRoot& b);
/// The distinct roots s with 0 < s < 1, in ascending order. PreconditionError: the zero polynomial.
std::vector<QuadraticRoot> RootsInside(const Quadratic& polynomial);
/// The sign that the polynomial has everywhere on 0 < s < 1; 0 if it is zero there or has roots there.
int SignInside(const Quadratic& polynomial);
/// "1/2" or "(1 + -1/2 sqrt(3))".
std::string ToString(const QuadraticRoot& number);
double ToDouble(const QuadraticRoot& number);

}  // namespace tact::algebra

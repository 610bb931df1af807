/// @file
/// Polynomials in one parameter, and vectors of three of them: how contacts move along a path.
/// Exact   rational coefficients, any degree.
#pragma once

#include <array>
#include <vector>

#include "algebra/screw/vector3.h"

namespace tact::algebra {

/// Coefficients from the constant one on; no trailing zeros.
using Polynomial = std::vector<Rational>;

inline void Trim(Polynomial* p) {
  while (!p->empty() && p->back().sign() == 0) p->pop_back();
}

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial product(a.size() + b.size() - 1);
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i].sign() == 0) continue;
    for (size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

/// a + factor * b.
inline Polynomial AddTimes(Polynomial a, const Rational& factor, const Polynomial& b) {
  if (a.size() < b.size()) a.resize(b.size());
  for (size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  Trim(&a);
  return a;
}
inline Polynomial operator+(const Polynomial& a, const Polynomial& b) { return AddTimes(a, 1, b); }
inline Polynomial operator-(const Polynomial& a, const Polynomial& b) { return AddTimes(a, -1, b); }

inline Rational ValueAt(const Polynomial& p, const Rational& s) {
  Rational value;
  for (size_t i = p.size(); i-- > 0;) value = value * s + p[i];
  return value;
}

using PolynomialVector = std::array<Polynomial, 3>;

inline bool IsZero(const PolynomialVector& v) { return v[0].empty() && v[1].empty() && v[2].empty(); }

inline PolynomialVector AsConstant(const Vector3& v) {
  PolynomialVector result;
  for (int i = 0; i < 3; ++i) {
    if (v[i].sign() != 0) result[i] = {v[i]};
  }
  return result;
}

/// The polynomials with these vectors as coefficients.
inline PolynomialVector FromCoefficients(const std::array<Vector3, 3>& coefficients) {
  PolynomialVector result;
  for (int i = 0; i < 3; ++i) {
    result[i] = {coefficients[0][i], coefficients[1][i], coefficients[2][i]};
    Trim(&result[i]);
  }
  return result;
}

inline PolynomialVector operator+(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline PolynomialVector operator-(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline PolynomialVector operator*(const Polynomial& s, const PolynomialVector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline Polynomial Dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline PolynomialVector Cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector3 ValueAt(const PolynomialVector& v, const Rational& s) {
  return {ValueAt(v[0], s), ValueAt(v[1], s), ValueAt(v[2], s)};
}

}  // namespace tact::algebra

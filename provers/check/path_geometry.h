/// @file
/// Corner points carried along a motion path (docs/certificates.md, `motion-path`), as polynomials.
/// Model   A point is (x, y, z) / w with w > 0 wherever it is used. A stage says which s: s = (start + step t) / scale
///         for 0 <= t < 1, a single s if step is 0.
/// Exact   integer coefficients; every positive common factor is left in.
#pragma once

#include "provers/check/json_value.h"
#include "provers/check/polynomial.h"

namespace tact::check {

struct PolynomialPoint {
  PolynomialVector xyz;
  Polynomial w;
};

struct Stage {
  mpz_class start, step, scale;
};

/// A rational number p / q, q > 0, from [p, q].
struct Fraction {
  mpz_class p, q;
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.p * b.q < b.p * a.q; }
  friend bool operator==(const Fraction& a, const Fraction& b) { return a.p * b.q == b.p * a.q; }
};
Fraction ReadFraction(const Value& value);
/// From one s to another, the other not included; and one s alone.
Stage Between(const Fraction& from, const Fraction& to);
Stage Only(const Fraction& s);

/// A line or a rotation as the certificate writes it.
struct Path {
  bool turns = false;
  Row point;   // of the axis, [X, Y, Z, W]
  Row vector;  // of the line, or of the axis, [X, Y, Z, W]

  /// X(s) p and its inverse, for p = [X, Y, Z, W].
  PolynomialPoint Carry(const Row& point, const Stage& stage) const;
  PolynomialPoint CarryBack(const Row& point, const Stage& stage) const;
  /// A positive multiple of R(s) v.
  PolynomialVector Turn(const Row& v, const Stage& stage) const;
};
/// Refused: neither one line nor one rotation, W not positive, a zero direction or axis.
Path ReadPath(const Value& value);

/// Points that stay where they are.
PolynomialPoint Standing(const Row& point);
/// A positive multiple of a - b.
Row Difference(const Row& a, const Row& b);
PolynomialVector Difference(const PolynomialPoint& a, const PolynomialPoint& b);

Row Cross(const Row& a, const Row& b);
mpz_class Dot(const Row& a, const Row& b);

}  // namespace tact::check

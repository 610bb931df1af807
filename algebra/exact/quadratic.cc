#include "algebra/exact/quadratic.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "algebra/error.h"

namespace tact::algebra {
namespace {

// The square root of an integer that is a square.
std::optional<Integer> ExactRoot(const Integer& n) {
  if (n.sign() < 0) return std::nullopt;
  mpz_t value, remainder;
  mpz_inits(value, remainder, nullptr);
  n.GetMpz(value);
  mpz_sqrtrem(value, remainder, value);
  std::optional<Integer> root;
  if (mpz_sgn(remainder) == 0) root = Integer::FromMpz(value);
  mpz_clears(value, remainder, nullptr);
  return root;
}

std::optional<Rational> ExactRoot(const Rational& q) {
  const auto numerator = ExactRoot(q.numerator()), denominator = ExactRoot(q.denominator());
  if (!numerator || !denominator) return std::nullopt;
  return Rational(*numerator, *denominator);
}

// All real roots, ascending.
std::vector<QuadraticRoot> Roots(const Quadratic& p) {
  if (p.c2.sign() == 0) {
    if (p.c1.sign() == 0) return {};
    return {{-p.c0 / p.c1, 0, 0}};
  }
  const Rational discriminant = p.c1 * p.c1 - Rational(4) * p.c0 * p.c2;
  if (discriminant.sign() < 0) return {};
  const Rational twice = Rational(2) * p.c2, center = -p.c1 / twice;
  if (discriminant.sign() == 0) return {{center, 0, 0}};
  const Rational step = Abs(Rational(1) / twice);
  if (const auto root = ExactRoot(discriminant))
    return {{center - step * *root, 0, 0}, {center + step * *root, 0, 0}};
  return {{center, -step, discriminant}, {center, step, discriminant}};
}

}  // namespace

int SignOf(const QuadraticRoot& number) {
  const int a = number.center.sign(), b = number.offset.sign();
  if (a == b || b == 0) return a;
  if (a == 0) return b;
  const Rational difference = number.center * number.center - number.offset * number.offset * number.radicand;
  return difference.sign() * a;
}

int SignAt(const Quadratic& p, const QuadraticRoot& r) {
  const Rational square = r.center * r.center + r.offset * r.offset * r.radicand;
  return SignOf({p.c0 + p.c1 * r.center + p.c2 * square, (p.c1 + Rational(2) * p.c2 * r.center) * r.offset,
                 r.radicand});
}

// x + y sqrt(D) with x = a - b's center and y = a's offset, against b's offset times the root of b's radicand:
// where the signs agree, the squares decide.
int Compare(const QuadraticRoot& a, const QuadraticRoot& b) {
  const QuadraticRoot left{a.center - b.center, a.offset, a.radicand};
  const int sign = SignOf(left), other = b.offset.sign();
  if (sign != other || sign == 0) return sign != 0 ? sign : -other;
  const QuadraticRoot squares{left.center * left.center + left.offset * left.offset * left.radicand -
                                  b.offset * b.offset * b.radicand,
                              Rational(2) * left.center * left.offset, left.radicand};
  return sign * SignOf(squares);
}

std::vector<QuadraticRoot> RootsInside(const Quadratic& polynomial) {
  if (polynomial.IsZero()) throw PreconditionError("every number is a root of the zero polynomial");
  const auto bernstein = polynomial.Bernstein();
  const auto all = [&](int sign) {
    return std::all_of(bernstein.begin(), bernstein.end(),
                       [&](const Rational& b) { return b.sign() * sign >= 0; });
  };
  if (all(1) || all(-1)) return {};  // a sum of (1-s)^2, s (1-s), s^2 with one sign, some of them there
  std::vector<QuadraticRoot> inside;
  for (const QuadraticRoot& root : Roots(polynomial)) {
    if (SignOf(root) > 0 && SignOf({root.center - Rational(1), root.offset, root.radicand}) < 0)
      inside.push_back(root);
  }
  return inside;
}

int SignInside(const Quadratic& polynomial) {
  if (polynomial.IsZero() || !RootsInside(polynomial).empty()) return 0;
  return polynomial.At(Rational(1, 2)).sign();
}

std::string ToString(const QuadraticRoot& number) {
  if (number.is_rational()) return number.center.ToString();
  return "(" + number.center.ToString() + " + " + number.offset.ToString() + " sqrt(" +
         number.radicand.ToString() + "))";
}

double ToDouble(const QuadraticRoot& number) {
  return ToDouble(number.center) + ToDouble(number.offset) * std::sqrt(ToDouble(number.radicand));
}

}  // namespace tact::algebra

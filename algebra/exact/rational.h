/// @file
/// Rational numbers in lowest terms, on Integer: 64-bit while numerator and denominator fit.
/// Exact   every operation. A decimal such as "1.25e-3" is the rational it writes.
/// Errors  PreconditionError: division by zero.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "algebra/exact/integer.h"

namespace tact::algebra {

class Rational {
 public:
  Rational() noexcept : denominator_(1) {}
  Rational(int value) noexcept : numerator_(value), denominator_(1) {}   // NOLINT: integers convert
  Rational(long value) noexcept : numerator_(value), denominator_(1) {}  // NOLINT
  Rational(Integer value) noexcept : numerator_(std::move(value)), denominator_(1) {}  // NOLINT
  /// numerator / denominator, brought to lowest terms; the denominator must not be zero.
  Rational(Integer numerator, Integer denominator);

  /// "p", "p/q" or a decimal with optional exponent ("-52.4999", "1e-3"); nullopt for anything else,
  /// among it "nan", "inf" and exponents beyond +-400 (no double has them).
  static std::optional<Rational> Parse(std::string_view text);
  /// The shortest decimal that reads back as this double (17 digits at most); precondition: finite.
  static Rational FromShortestDecimal(double value);

  const Integer& numerator() const noexcept { return numerator_; }
  /// Positive.
  const Integer& denominator() const noexcept { return denominator_; }
  int sign() const noexcept { return numerator_.sign(); }
  bool is_integer() const noexcept { return denominator_ == Integer(1); }
  /// "p" or "p/q".
  std::string ToString() const;
  /// The decimal, exactly, if it has at most 15 places after the point ("0.013"); otherwise "p/q".
  std::string ToDecimal() const;

  Rational operator-() const;
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator-=(const Rational& b) { return *this = *this - b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  Rational& operator/=(const Rational& b) { return *this = *this / b; }

  friend bool operator==(const Rational& a, const Rational& b) noexcept = default;
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

 private:
  Integer numerator_;
  Integer denominator_;
};

/// Nearest double, up to one unit in the last place.
double ToDouble(const Rational& a);
Rational Abs(const Rational& a);

}  // namespace tact::algebra

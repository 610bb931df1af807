/// @file
/// Integers of any size: 64 bits while they fit, GMP from the first overflow on.
/// Exact   every operation; overflow is detected, never wrapped.
/// Errors  PreconditionError: division by zero, DivideExactly with a remainder is not checked.
/// Cost    an overflow-checked machine operation while small; one GMP operation and an allocation when large.
#pragma once

#include <gmp.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tact::algebra {

class Integer {
 public:
  Integer() noexcept = default;
  Integer(int value) noexcept : value_(value) {}        // NOLINT: integers convert
  Integer(long value) noexcept : value_(value) {}       // NOLINT
  Integer(long long value) noexcept : value_(value) {}  // NOLINT
  Integer(const Integer& other) : value_(other.value_) {
    if (other.big_ != nullptr) CopyBig(other);
  }
  Integer(Integer&& other) noexcept : value_(other.value_), big_(other.big_) { other.big_ = nullptr; }
  Integer& operator=(const Integer& other);
  Integer& operator=(Integer&& other) noexcept;
  ~Integer() {
    if (big_ != nullptr) FreeBig();
  }

  /// Takes a copy of a GMP integer; small again if it fits.
  static Integer FromMpz(mpz_srcptr value);
  /// Decimal digits with an optional sign; nullopt for anything else.
  static std::optional<Integer> Parse(std::string_view text);

  bool is_small() const noexcept { return big_ == nullptr; }
  /// The value; precondition is_small().
  int64_t small() const noexcept { return value_; }
  /// -1, 0 or 1.
  int sign() const noexcept;
  /// Number of bits of |this|; 0 for zero.
  size_t bits() const noexcept;
  /// Writes the value into an initialised mpz.
  void GetMpz(mpz_ptr out) const;
  std::string ToString() const;

  Integer operator-() const;
  friend Integer operator+(const Integer& a, const Integer& b);
  friend Integer operator-(const Integer& a, const Integer& b);
  friend Integer operator*(const Integer& a, const Integer& b);
  /// a / b where b is known to divide a.
  friend Integer DivideExactly(const Integer& a, const Integer& b);
  /// Non-negative; Gcd(0, 0) = 0.
  friend Integer Gcd(const Integer& a, const Integer& b);
  Integer& operator+=(const Integer& b) { return *this = *this + b; }
  Integer& operator-=(const Integer& b) { return *this = *this - b; }
  Integer& operator*=(const Integer& b) { return *this = *this * b; }

  friend bool operator==(const Integer& a, const Integer& b) noexcept;
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) noexcept;
  /// Nearest double; may overflow to infinity.
  friend double ToDouble(const Integer& a);

 private:
  void CopyBig(const Integer& other);
  void FreeBig() noexcept;

  int64_t value_ = 0;
  mpz_ptr big_ = nullptr;  // owned; null while the value fits in value_
};

Integer Abs(const Integer& a);
Integer DivideExactly(const Integer& a, const Integer& b);
Integer Gcd(const Integer& a, const Integer& b);
double ToDouble(const Integer& a);

}  // namespace tact::algebra

/// @file
/// 64-bit integers that throw on overflow: the fast scalar of kernels written once for Word and for Integer.
/// Model   A kernel is a template over its scalar; WordsFirst runs it on Word and, from the first overflow
///         on, again on Integer.
/// Exact   no operation wraps; a result is right or WordOverflow is thrown. The value -2^63 is never held.
/// Cost    one overflow-checked machine operation; MultiplySubtractDivide uses 128 bits where 64 do not do.
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>

#include "algebra/exact/integer.h"

namespace tact::algebra {

/// Thrown by Word, caught by WordsFirst; no other use.
struct WordOverflow {};

class Word {
 public:
  Word() noexcept = default;
  Word(int value) noexcept : value_(value) {}  // NOLINT: integers convert
  static Word FromInt64(int64_t value) {
    if (value == std::numeric_limits<int64_t>::min()) throw WordOverflow();
    Word word;
    word.value_ = value;
    return word;
  }

  int64_t value() const noexcept { return value_; }
  int sign() const noexcept { return (value_ > 0) - (value_ < 0); }
  Word operator-() const noexcept {
    Word result;
    result.value_ = -value_;
    return result;
  }
  friend Word operator+(Word a, Word b) {
    int64_t result = 0;
    if (__builtin_add_overflow(a.value_, b.value_, &result)) throw WordOverflow();
    return FromInt64(result);
  }
  friend Word operator-(Word a, Word b) {
    int64_t result = 0;
    if (__builtin_sub_overflow(a.value_, b.value_, &result)) throw WordOverflow();
    return FromInt64(result);
  }
  friend Word operator*(Word a, Word b) {
    int64_t result = 0;
    if (__builtin_mul_overflow(a.value_, b.value_, &result)) throw WordOverflow();
    return FromInt64(result);
  }
  Word& operator+=(Word b) { return *this = *this + b; }
  friend bool operator==(Word a, Word b) noexcept = default;
  friend auto operator<=>(Word a, Word b) noexcept = default;

 private:
  int64_t value_ = 0;
};

inline Word DivideExactly(Word a, Word b) { return Word::FromInt64(a.value() / b.value()); }
inline Word Gcd(Word a, Word b) { return Word::FromInt64(std::gcd(a.value(), b.value())); }

/// (a b - c d) / e, where e is known to divide it: the step of fraction-free elimination.
inline Integer MultiplySubtractDivide(const Integer& a, const Integer& b, const Integer& c, const Integer& d,
                                      const Integer& e) {
  return DivideExactly(a * b - c * d, e);
}

inline Word MultiplySubtractDivide(Word a, Word b, Word c, Word d, Word e) {
  int64_t ab = 0, cd = 0, difference = 0;
  if (!__builtin_mul_overflow(a.value(), b.value(), &ab) &&
      !__builtin_mul_overflow(c.value(), d.value(), &cd) && !__builtin_sub_overflow(ab, cd, &difference) &&
      difference != std::numeric_limits<int64_t>::min()) {
    return Word::FromInt64(difference / e.value());
  }
  __extension__ using Int128 = __int128;  // holds every a b - c d of four Words
  const Int128 wide =
      (static_cast<Int128>(a.value()) * b.value() - static_cast<Int128>(c.value()) * d.value()) / e.value();
  const auto narrow = static_cast<int64_t>(wide);
  if (narrow != wide) throw WordOverflow();
  return Word::FromInt64(narrow);
}

/// The value as a kernel's scalar; WordOverflow where it does not fit.
template <typename Scalar>
Scalar FromInteger(const Integer& value);
template <>
inline Integer FromInteger<Integer>(const Integer& value) {
  return value;
}
template <>
inline Word FromInteger<Word>(const Integer& value) {
  if (!value.is_small()) throw WordOverflow();
  return Word::FromInt64(value.small());
}
inline const Integer& ToInteger(const Integer& value) { return value; }
inline Integer ToInteger(Word value) { return static_cast<long long>(value.value()); }

/// kernel(Word()), or kernel(Integer()) if that overflows. The kernel must leave nothing changed when it
/// throws.
template <typename Kernel>
auto WordsFirst(const Kernel& kernel) {
  try {
    return kernel(Word());
  } catch (const WordOverflow&) {
    return kernel(Integer());
  }
}

/// Divides n entries by their greatest common divisor; zeros stay zeros.
template <typename Scalar>
void MakePrimitive(Scalar* entries, size_t n) {
  Scalar common(0);
  const Scalar one(1);
  for (size_t i = 0; i < n && common != one; ++i) common = Gcd(common, entries[i]);
  if (common == one || common.sign() == 0) return;
  for (size_t i = 0; i < n; ++i) entries[i] = DivideExactly(entries[i], common);
}

}  // namespace tact::algebra

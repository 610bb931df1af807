#include "algebra/exact/rational.h"

#include <charconv>
#include <utility>

#include "algebra/error.h"

namespace tact::algebra {
namespace {

constexpr int kLargestExponent = 400;

Integer PowerOfTen(int exponent) {
  Integer power(1);
  for (int i = 0; i < exponent; ++i) power *= Integer(10);
  return power;
}

// digits[.digits][e[+-]digits], sign already taken off.
std::optional<Rational> ParseDecimal(std::string_view text) {
  std::string digits;
  int exponent = 0;
  size_t i = 0;
  for (; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i) digits += text[i];
  if (i < text.size() && text[i] == '.') {
    for (++i; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i) {
      digits += text[i];
      --exponent;
    }
  }
  if (digits.empty()) return std::nullopt;
  if (i < text.size()) {
    if (text[i] != 'e' && text[i] != 'E') return std::nullopt;
    ++i;
    if (i < text.size() && text[i] == '+') ++i;
    int written = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + i, end, written);
    if (error != std::errc() || stop != end) return std::nullopt;
    if (written > kLargestExponent || written < -kLargestExponent) return std::nullopt;
    exponent += written;
  }
  const Integer mantissa = *Integer::Parse(digits);
  return exponent >= 0 ? Rational(mantissa * PowerOfTen(exponent))
                       : Rational(mantissa, PowerOfTen(-exponent));
}

}  // namespace

Rational::Rational(Integer numerator, Integer denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  if (denominator_.sign() == 0) throw PreconditionError("a rational with denominator zero");
  if (denominator_.sign() < 0) {
    numerator_ = -numerator_;
    denominator_ = -denominator_;
  }
  const Integer common = Gcd(numerator_, denominator_);
  if (common != Integer(1)) {
    numerator_ = DivideExactly(numerator_, common);
    denominator_ = DivideExactly(denominator_, common);
  }
}

std::optional<Rational> Rational::Parse(std::string_view text) {
  if (text.empty()) return std::nullopt;
  if (const size_t slash = text.find('/'); slash != std::string_view::npos) {
    const auto p = Integer::Parse(text.substr(0, slash));
    const auto q = Integer::Parse(text.substr(slash + 1));
    if (!p || !q || q->sign() == 0) return std::nullopt;
    return Rational(*p, *q);
  }
  const bool negative = text[0] == '-';
  if (text[0] == '-' || text[0] == '+') text.remove_prefix(1);
  const auto magnitude = ParseDecimal(text);
  if (!magnitude) return std::nullopt;
  return negative ? -*magnitude : *magnitude;
}

Rational Rational::FromShortestDecimal(double value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  const auto result = Parse(std::string_view(text, static_cast<size_t>(end - text)));
  if (error != std::errc() || !result) throw PreconditionError("not a finite number");
  return *result;
}

std::string Rational::ToString() const {
  return is_integer() ? numerator_.ToString() : numerator_.ToString() + "/" + denominator_.ToString();
}

std::string Rational::ToDecimal() const {
  constexpr int kMostPlaces = 15;
  Integer power(1);
  for (int places = 0; places <= kMostPlaces; ++places, power *= Integer(10)) {
    const Rational scaled = *this * Rational(power);
    if (!scaled.is_integer()) continue;
    std::string digits = Abs(scaled.numerator()).ToString();
    if (digits.size() <= static_cast<size_t>(places)) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, ".");
    return (sign() < 0 ? "-" : "") + digits;
  }
  return ToString();
}

Rational Rational::operator-() const {
  Rational result = *this;
  result.numerator_ = -result.numerator_;
  return result;
}

Rational operator+(const Rational& a, const Rational& b) {
  if (a.is_integer() && b.is_integer()) return Rational(a.numerator_ + b.numerator_);
  return Rational(a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
                  a.denominator_ * b.denominator_);
}

Rational operator-(const Rational& a, const Rational& b) {
  if (a.is_integer() && b.is_integer()) return Rational(a.numerator_ - b.numerator_);
  return Rational(a.numerator_ * b.denominator_ - b.numerator_ * a.denominator_,
                  a.denominator_ * b.denominator_);
}

Rational operator*(const Rational& a, const Rational& b) {
  return Rational(a.numerator_ * b.numerator_, a.denominator_ * b.denominator_);
}

Rational operator/(const Rational& a, const Rational& b) {
  return Rational(a.numerator_ * b.denominator_, a.denominator_ * b.numerator_);
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return a.numerator_ * b.denominator_ <=> b.numerator_ * a.denominator_;
}

double ToDouble(const Rational& a) {
  const double p = ToDouble(a.numerator());
  const double q = ToDouble(a.denominator());
  if (a.numerator().is_small() && a.denominator().is_small()) return p / q;
  mpq_t ratio;
  mpq_init(ratio);
  a.numerator().GetMpz(mpq_numref(ratio));
  a.denominator().GetMpz(mpq_denref(ratio));
  const double result = mpq_get_d(ratio);
  mpq_clear(ratio);
  return result;
}

Rational Abs(const Rational& a) { return a.sign() < 0 ? -a : a; }

}  // namespace tact::algebra

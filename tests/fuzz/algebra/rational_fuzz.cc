/// @file
/// Whatever Rational::Parse accepts survives printing and parsing again, and arithmetic on it undoes itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "algebra/exact/rational.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using tact::algebra::Rational;
  const auto parsed = Rational::Parse(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!parsed) return 0;
  const Rational& a = *parsed;
  if (Rational::Parse(a.ToString()) != a) std::abort();
  const Rational third(1, 3);
  if (a + third - third != a || a * third / third != a || (a - a).sign() != 0) std::abort();
  if ((a < Rational(0)) != (a.sign() < 0) || a.denominator().sign() <= 0) std::abort();
  return 0;
}

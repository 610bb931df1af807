#include "algebra/exact/integer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "algebra/error.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

constexpr int64_t kMin = std::numeric_limits<int64_t>::min(), kMax = std::numeric_limits<int64_t>::max();

Integer Parsed(const std::string& text) { return *Integer::Parse(text); }

// Around 0, around the border of 64 bits and far beyond it.
Integer AnyInteger() {
  const Integer base =
      std::array<Integer, 6>{0,
                             kMin,
                             kMax,
                             Integer(1L << 32),
                             Integer(kMin) * Integer(kMin),
                             Parsed("-340282366920938463463374607431768211456")}[Uniform(0, 6)];
  return base + Integer(Uniform(-5, 6));
}

// The same by GMP alone.
template <typename Operation>
std::string Gmp(const Integer& a, const Integer& b, Operation operation) {
  mpz_t x, y, z;
  mpz_inits(x, y, z, nullptr);
  mpz_set_str(x, a.ToString().c_str(), 10);
  mpz_set_str(y, b.ToString().c_str(), 10);
  operation(z, x, y);
  char* text = mpz_get_str(nullptr, 10, z);
  const std::string result(text);
  void (*release)(void*, size_t) = nullptr;
  mp_get_memory_functions(nullptr, nullptr, &release);
  release(text, result.size() + 1);
  mpz_clears(x, y, z, nullptr);
  return result;
}

TEST(Integer, LeavesSixtyFourBitsAndComesBack) {
  const Integer over = Integer(kMax) + 1;
  EXPECT_FALSE(over.is_small());
  EXPECT_EQ(over.ToString(), "9223372036854775808");
  EXPECT_EQ(-Integer(kMin), over);
  EXPECT_EQ(Abs(kMin), over);
  const Integer back = over - 1;
  EXPECT_TRUE(back.is_small());
  EXPECT_EQ(back.small(), kMax);
  EXPECT_TRUE((-over).is_small());
  EXPECT_EQ((-over).small(), kMin);
}

TEST(Integer, TheSmallestWordDivides) {
  EXPECT_EQ(DivideExactly(kMin, -1).ToString(), "9223372036854775808");
  EXPECT_EQ(Gcd(kMin, 0).ToString(), "9223372036854775808");
  EXPECT_EQ(Gcd(kMin, kMin).ToString(), "9223372036854775808");
  EXPECT_EQ(Gcd(0, 0), Integer(0));
  EXPECT_THROW(DivideExactly(1, 0), PreconditionError);
}

TEST(Integer, ParsesDigitsWithASignOnly) {
  EXPECT_EQ(Integer::Parse("+17"), Integer(17));
  EXPECT_EQ(Integer::Parse("-9223372036854775808"), Integer(kMin));
  EXPECT_EQ(Integer::Parse("-0"), Integer(0));
  EXPECT_EQ(Integer::Parse("000000000000000000000000000042"), Integer(42));
  for (const char* text :
       {"", "+", "-", "+-1", "--1", " 1", "1 ", "0x1", "1e3", "1.0", "12345678901234567890a"}) {
    EXPECT_FALSE(Integer::Parse(text).has_value()) << text;
  }
}

TEST(Integer, CountsBits) {
  EXPECT_EQ(Integer(0).bits(), 0u);
  EXPECT_EQ(Integer(-1).bits(), 1u);
  EXPECT_EQ(Integer(255).bits(), 8u);
  EXPECT_EQ(Integer(kMin).bits(), 64u);
  EXPECT_EQ((Integer(kMin) * 2).bits(), 65u);
}

// 2^64 + 2^11 lies halfway between two doubles: to the even one, and any more goes up.
TEST(Integer, TheNearestDoubleIsNearest) {
  EXPECT_EQ(ToDouble(Parsed("18446744073709553664")), std::ldexp(1.0, 64));
  EXPECT_EQ(ToDouble(Parsed("18446744073709553665")), std::nextafter(std::ldexp(1.0, 64), HUGE_VAL));
  EXPECT_EQ(ToDouble(Parsed("-18446744073709553665")), -std::nextafter(std::ldexp(1.0, 64), HUGE_VAL));
  EXPECT_EQ(ToDouble(Integer(kMax)), std::ldexp(1.0, 63));
  EXPECT_EQ(ToDouble(Parsed("9223372036854775808")), std::ldexp(1.0, 63));
  EXPECT_EQ(ToDouble(Parsed("1" + std::string(400, '0'))), HUGE_VAL);
  EXPECT_EQ(ToDouble(Parsed("-1" + std::string(5000, '0'))), -HUGE_VAL);
}

TEST(Integer, CopiesAndMovesKeepTheirValues) {
  Integer big = Parsed("123456789012345678901234567890"), copy = big, small = 7;
  copy += 1;
  EXPECT_EQ(big.ToString(), "123456789012345678901234567890");
  EXPECT_EQ(copy - big, Integer(1));
  Integer& self = big;
  big = self;
  EXPECT_EQ(big.ToString(), "123456789012345678901234567890");
  Integer moved = std::move(copy);
  moved = std::move(small);
  EXPECT_EQ(moved, Integer(7));
  moved = big;
  small = moved;
  EXPECT_EQ(small, big);
}

RC_GTEST_PROP(IntegerTwin, AgreesWithGmp, ()) {
  const Integer a = AnyInteger(), b = AnyInteger();
  RC_ASSERT((a + b).ToString() == Gmp(a, b, mpz_add));
  RC_ASSERT((a - b).ToString() == Gmp(a, b, mpz_sub));
  RC_ASSERT((a * b).ToString() == Gmp(a, b, mpz_mul));
  RC_ASSERT(Gcd(a, b).ToString() == Gmp(a, b, mpz_gcd));
  if (b.sign() != 0) RC_ASSERT(DivideExactly(a * b, b) == a);
  RC_ASSERT((a <=> b) == ((a - b).sign() <=> 0));
  RC_ASSERT((a == b) == (a.ToString() == b.ToString()));
  RC_ASSERT(Integer::Parse(a.ToString()) == a);
}

}  // namespace
}  // namespace tact::algebra

#include "algebra/exact/rational.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/error.h"

namespace tact::algebra {
namespace {

TEST(Rational, DecimalsAreTakenExactly) {
  EXPECT_EQ(Rational::Parse("-52.4999999999999"),
            Rational(*Integer::Parse("-524999999999999"), *Integer::Parse("10000000000000")));
  EXPECT_EQ(Rational::Parse("1.25e-3"), Rational(1, 800));
  EXPECT_EQ(Rational::Parse("1E2"), Rational(100));
  EXPECT_EQ(Rational::Parse("6/-4"), Rational(-3, 2));
  EXPECT_EQ(Rational::Parse(".5"), Rational(1, 2));
}

TEST(Rational, WhatIsNoNumberIsRefused) {
  for (const char* text :
       {"", "-", "nan", "inf", "1e400000", "1e999", "1/0", "1.2.3", "0x10", "1e", "--1", "1/2/3", " 1"}) {
    EXPECT_FALSE(Rational::Parse(text).has_value()) << text;
  }
}

TEST(Rational, DivisionByZeroIsRefused) {
  EXPECT_THROW(Rational(1) / Rational(0), PreconditionError);
  EXPECT_THROW(Rational(Integer(1), Integer(0)), PreconditionError);
}

TEST(Rational, ShortestDecimalOfADoubleIsTheDecimalAPersonWrote) {
  EXPECT_EQ(Rational::FromShortestDecimal(0.027713), *Rational::Parse("0.027713"));
}

TEST(Rational, PrintsAsTheExactDecimalWhereThereIsOne) {
  EXPECT_EQ(Rational(13, 1000).ToDecimal(), "0.013");
  EXPECT_EQ(Rational(-5, 2).ToDecimal(), "-2.5");
  EXPECT_EQ(Rational(40).ToDecimal(), "40");
  EXPECT_EQ(Rational(1, 3).ToDecimal(), "1/3");
  EXPECT_EQ(Rational(Integer(1), Integer(1L << 20)).ToDecimal(), "1/1048576");  // 20 places
}

// Overflow of 64 bits must go unnoticed: the same laws on numbers around 2^63.
rc::Gen<Rational> AnyRational() {
  return rc::gen::map(rc::gen::tuple(rc::gen::arbitrary<int64_t>(), rc::gen::nonZero<int64_t>()),
                      [](const std::tuple<int64_t, int64_t>& pq) {
                        return Rational(Integer(static_cast<long>(std::get<0>(pq))),
                                        Integer(static_cast<long>(std::get<1>(pq))));
                      });
}

RC_GTEST_PROP(RationalLaw, FieldAxioms, ()) {
  const Rational a = *AnyRational(), b = *AnyRational(), c = *AnyRational();
  RC_ASSERT((a + b) + c == a + (b + c));
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT(a * (b + c) == a * b + a * c);
  RC_ASSERT(a - a == Rational(0));
  if (b.sign() != 0) RC_ASSERT((a / b) * b == a);
  RC_ASSERT((a < b) == ((a - b).sign() < 0));
}

RC_GTEST_PROP(RationalLaw, TextRoundTrip, ()) {
  const Rational a = *AnyRational() * *AnyRational();
  RC_ASSERT(Rational::Parse(a.ToString()) == a);
}

}  // namespace
}  // namespace tact::algebra

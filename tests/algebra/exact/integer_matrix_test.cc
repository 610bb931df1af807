#include "algebra/exact/integer_matrix.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/error.h"
#include "algebra/exact/rational.h"

namespace tact::algebra {
namespace {

TEST(IntegerMatrix, AProductOfVectorsOfDifferentLengthsIsRefusedWithBoth) {
  try {
    Dot(IntegerVector{1, 2}, IntegerVector{1, 2, 3});
    FAIL() << "accepted";
  } catch (const PreconditionError& error) {
    EXPECT_STREQ(error.what(), "a product of vectors with 2 and 3 entries");
  }
}

// By hand.
TEST(IntegerMatrix, MultipliesEachRow) {
  const IntegerMatrix a = IntegerMatrix::FromRows({{1, 2, 3}, {-4, 0, 5}}, 3);
  EXPECT_EQ(Multiply(a, IntegerVector{7, -1, 2}), (IntegerVector{11, -18}));
  EXPECT_THROW(Multiply(a, IntegerVector{1, 2}), PreconditionError);
}

// By hand: times 30, then over 7.
TEST(IntegerMatrix, PrimitiveClearsDenominatorsAndCommonFactors) {
  const std::vector<Rational> v = {Rational(7, 6), Rational(0), Rational(-14, 15)};
  const IntegerVector primitive = Primitive(v);
  EXPECT_EQ(primitive, (IntegerVector{5, 0, -4}));
  EXPECT_EQ(ToString(primitive), "(5, 0, -4)");
  EXPECT_EQ(ToString(IntegerVector{}), "()");
}

RC_GTEST_PROP(IntegerMatrixLaw, TransposeMovesToTheOtherSideOfAProduct, ()) {
  const size_t rows = *rc::gen::inRange<size_t>(1, 5), columns = *rc::gen::inRange<size_t>(1, 5);
  const auto vector = [](size_t size) {
    IntegerVector v;
    for (size_t i = 0; i < size; ++i) v.push_back(Integer(*rc::gen::arbitrary<int64_t>()));
    return v;
  };
  IntegerMatrix a(0, columns);
  for (size_t i = 0; i < rows; ++i) a.AppendRow(vector(columns));
  const IntegerVector x = vector(columns), y = vector(rows);
  RC_ASSERT(Dot(y, Multiply(a, x)) == Dot(Multiply(Transpose(a), y), x));
}

}  // namespace
}  // namespace tact::algebra

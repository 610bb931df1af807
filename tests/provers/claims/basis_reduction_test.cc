#include "provers/claims/basis_reduction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "algebra/exact/linear_algebra.h"

namespace tact::provers {
namespace {

using algebra::Integer;
using algebra::IntegerMatrix;

IntegerMatrix AngularParts(const IntegerMatrix& screws) {
  const std::vector<size_t> angular = {0, 1, 2};
  return SelectColumns(screws, angular);
}

// Independent screws in a random space; with few axis directions, so that translations are common.
std::vector<Screw> AnyBasis() {
  std::vector<Screw> screws;
  const int tries = *rc::gen::inRange(0, 9), axes = *rc::gen::inRange(0, 4);
  for (int i = 0; i < tries; ++i) {
    Screw screw;
    for (int j = 0; j < 6; ++j) screw.push_back(Integer(j < 3 && j >= axes ? 0 : *rc::gen::inRange(-3, 4)));
    screws.push_back(screw);
    if (Rank(IntegerMatrix::FromRows(screws, 6)) < screws.size()) screws.pop_back();
  }
  return screws;
}

RC_GTEST_PROP(ReduceBasisLaw, KeepsTheSpaceAndSetsItsTranslationsApart, ()) {
  const std::vector<Screw> screws = AnyBasis();
  const auto before = IntegerMatrix::FromRows(screws, 6);
  const size_t axes = Rank(AngularParts(before));
  for (const bool last : {false, true}) {
    const ReducedBasis reduced = ReduceBasis(screws, last);
    const auto after = IntegerMatrix::FromRows(reduced.screws, 6);
    RC_ASSERT(after.rows == before.rows);
    RC_ASSERT(RowSpace(after).vectors == RowSpace(before).vectors);
    // Rank and nullity of the projection to angular parts.
    RC_ASSERT(reduced.translations == static_cast<int>(before.rows - axes));
    const IntegerMatrix angular = AngularParts(after);
    size_t turning = 0;
    for (size_t i = 0; i < angular.rows; ++i) turning += angular.IsZeroRow(i) ? 0 : 1;
    RC_ASSERT(turning == axes);
    RC_ASSERT(turning + static_cast<size_t>(reduced.translations) == screws.size());
  }
}

RC_GTEST_PROP(ReduceBasisLaw, EachRoundLeavesOneTurningScrewFewer, ()) {
  const std::vector<Screw> screws = AnyBasis();
  const IntegerMatrix angular = AngularParts(IntegerMatrix::FromRows(screws, 6));
  int turning = 0;
  for (size_t i = 0; i < angular.rows; ++i) turning += angular.IsZeroRow(i) ? 0 : 1;
  RC_ASSERT(ReduceBasis(screws, false).rounds == turning - static_cast<int>(Rank(angular)));
}

TEST(ReduceBasis, TwoParallelAxesMakeATranslationByHand) {
  // Turning about z through 0 and, twice as fast, through x = 1: v = w x (0 - p) = (0, -2, 0).
  const Screw through_0 = {0, 0, 1, 0, 0, 0}, through_x = {0, 0, 2, 0, -2, 0};
  const ReducedBasis reduced = ReduceBasis({through_0, through_x}, true);
  EXPECT_EQ(reduced.rounds, 1);
  EXPECT_EQ(reduced.translations, 1);
  EXPECT_EQ(reduced.screws[0], through_0);
  const Screw &t = reduced.screws[1], along_y = {0, 0, 0, 0, 1, 0};
  EXPECT_EQ(Rank(IntegerMatrix::FromRows({t, along_y}, 6)), 1u);
  EXPECT_EQ(ReduceBasis({through_0, through_x}, false).screws[0], through_x);
}

TEST(ReduceBasis, NothingAndTranslationsAloneStayAsTheyAre) {
  EXPECT_TRUE(ReduceBasis({}, false).screws.empty());
  const std::vector<Screw> translations = {{0, 0, 0, 1, 2, 0}, {0, 0, 0, 0, 0, 3}};
  const ReducedBasis reduced = ReduceBasis(translations, true);
  EXPECT_EQ(reduced.screws, translations);
  EXPECT_EQ(reduced.translations, 2);
  EXPECT_EQ(reduced.rounds, 0);
}

}  // namespace
}  // namespace tact::provers

#include "enumerators/contact_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algebra/error.h"

namespace tact::enumerators {
namespace {

// Twin: all subsets as bit masks, sorted.
TEST(ContactSets, AreAllSubsetsOfThatSizeInOrder) {
  std::vector<std::vector<size_t>> expected;
  for (size_t mask = 0; mask < 64; ++mask) {
    std::vector<size_t> set;
    for (size_t i = 0; i < 6; ++i) {
      if ((mask >> i) % 2 == 1) set.push_back(i);
    }
    if (set.size() <= 4) expected.push_back(set);
  }
  std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return ComesBefore(a, b); });
  const ContactSets sets(6, 4);
  ASSERT_EQ(sets.size(), expected.size());
  std::vector<size_t> walked = sets.At(0);
  for (uint64_t number = 0; number < sets.size(); ++number, sets.Advance(walked)) {
    EXPECT_EQ(sets.At(number), expected[number]);
    EXPECT_EQ(walked, expected[number]);
  }
}

TEST(ContactSets, OfNothingAndOfAllAtMost) {
  EXPECT_EQ(ContactSets(5, 0).size(), 1U);
  EXPECT_EQ(ContactSets(0, 3).size(), 1U);
  EXPECT_EQ(ContactSets(3, 9).size(), 8U);
  EXPECT_EQ(ContactSets(62, 62).size(), uint64_t{1} << 62);
}

TEST(ContactSets, TooManyAndTooFarAreRefused) {
  EXPECT_THROW(ContactSets(63, 63), PreconditionError);
  EXPECT_THROW(ContactSets(1000, 40), PreconditionError);
  EXPECT_THROW(ContactSets(3, 3).At(8), PreconditionError);
}

TEST(WorldRows, AreSixNumbersAContact) {
  const ContactWorld world{"", {{{1, 2, 3}, {{0, 0, 2}}, ""}}, 1};
  EXPECT_EQ(WorldRows(world), (std::vector<int64_t>{2, -1, 0, 0, 0, 1}));  // (1, 2, 3) x z, by hand
}

TEST(WorldRows, SingularContactsAndLargeNumbersAreRefused) {
  EXPECT_THROW(WorldRows(SingularWorld(1)), PreconditionError);
  const algebra::Rational large(algebra::Integer(int64_t{1} << 61));
  EXPECT_THROW(WorldRows({"", {{{large, 0, 0}, {{0, 0, 1}}, ""}}, 1}), PreconditionError);
}

}  // namespace
}  // namespace tact::enumerators

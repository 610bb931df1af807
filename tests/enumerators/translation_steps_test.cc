#include "enumerators/translation_steps.h"

#include <gtest/gtest.h>

#include <map>

namespace tact::enumerators {
namespace {

std::map<std::string, size_t> Sizes(size_t largest) {
  std::map<std::string, size_t> sizes;
  for (const StepDefinition& d : TranslationSteps(largest)) sizes[d.name] = d.steps.size();
  return sizes;
}

// By hand (docs/dof-transitions.md): (m, d, c) -> (m - 1, d + 1, c) from the six kinds with m > 0, or
// (m, d - k, c + k) with 1 <= k <= d: 3 + 4 + 3; all pairs with m falling or equal and c rising or equal: 40.
TEST(TranslationSteps, CountsByHand) {
  const auto sizes = Sizes(4);
  EXPECT_EQ(sizes.at("one contact is added"), 6U + 10U);
  EXPECT_EQ(sizes.at("one contact is added, met head on"), 6U);
  EXPECT_EQ(sizes.at("several contacts are added, met head on"), 10U);
  EXPECT_EQ(sizes.at("one DOF goes from maintaining to detaching or from detaching to constraining"), 12U);
  EXPECT_EQ(
      sizes.at("one contact, or the two walls of a slot, are added by a translation that keeps the others"),
      13U);
  EXPECT_EQ(sizes.at("any contacts are added"), 40U);
}

TEST(TranslationSteps, MoreNormalsGiveNoMoreSteps) { EXPECT_EQ(Sizes(4), Sizes(5)); }

}  // namespace
}  // namespace tact::enumerators

#include "algebra/knot/gauss_code.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

TEST(GaussCode, ThesisExamplesByHand) {
  // Figure 5.2: over/+, over/-, under/-, and their other strands.
  const GaussCode code = GaussCodeOf(PData({4, 5, 6, 1, 2, 3}, {3, 1, 2, 4, 2, 1}));
  EXPECT_EQ(code, (GaussCode{{1, 2, -3, -1, -2, 3}, {1, -1, -1}}));
  EXPECT_EQ(ToText(code), "O1+ O2- U3- U1+ U2- O3-");
  EXPECT_EQ(ToExtendedText(code), "1 2 -3 -1 -2 3 +--");
  EXPECT_EQ(ToText(GaussCodeOf(PData())), "/");
  EXPECT_EQ(ToExtendedText(GaussCodeOf(PData())), "/");
}

TEST(GaussCode, NothingIsLostOnAnyPDataToFourCrossings) {
  for (int c = 0; c <= 4; ++c) {
    ForEachPData(c, [](const PData& p) {
      const GaussCode code = GaussCodeOf(p);
      ASSERT_FALSE(FindGaussFault(code)) << p.ToJson();
      ASSERT_EQ(PDataOf(code), p) << p.ToJson();
    });
  }
}

TEST(GaussCode, NothingIsLostOnRandomRopesToFortyCrossings) {
  std::mt19937_64 random(11);
  for (int crossings = 5; crossings <= 40; ++crossings) {
    const PData p = RandomPData(random, crossings);
    EXPECT_EQ(PDataOf(GaussCodeOf(p)), p) << p.ToJson();
  }
}

TEST(GaussCode, NumbersMayComeInAnyOrder) {
  EXPECT_EQ(PDataOf({{2, -1, -2, 1}, {-1, 1}}), PDataOf({{1, -2, -1, 2}, {1, -1}}));
}

// One number or sign of a good code changed: never accepted as the same P-data.
TEST(GaussCode, EveryChangedCodeIsRefusedOrAnother) {
  const GaussCode good{{1, 2, -3, -1, -2, 3}, {1, -1, -1}};
  for (size_t i = 0; i < good.passes.size(); ++i) {
    for (int number = -4; number <= 4; ++number) {
      if (number == good.passes[i]) continue;
      GaussCode bad = good;
      bad.passes[i] = number;
      EXPECT_TRUE(FindGaussFault(bad)) << i << " " << number;
      EXPECT_THROW(PDataOf(bad), PreconditionError);
    }
  }
  for (size_t i = 0; i < good.signs.size(); ++i) {
    GaussCode other = good;
    other.signs[i] = -other.signs[i];
    EXPECT_NE(PDataOf(other), PDataOf(good));
    other.signs[i] = 0;
    EXPECT_TRUE(FindGaussFault(other));
  }
  GaussCode shorter = good;
  shorter.passes.pop_back();
  EXPECT_TRUE(FindGaussFault(shorter));
}

}  // namespace
}  // namespace tact::knot

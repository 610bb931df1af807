#include "enumerators/planar_p_data.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::enumerators {
namespace {

TEST(PlanarPData, AreThoseAmongAllArraysThatASphereHolds) {
  for (int n = 0; n <= 3; ++n) {
    std::vector<knot::PData> grown, brute = knot::PlanarPData(n);
    ForEachPlanarPData(n, [&](const knot::PData& p) { grown.push_back(p); });
    std::sort(grown.begin(), grown.end());
    std::sort(brute.begin(), brute.end());
    EXPECT_EQ(grown, brute);
  }
}

// OEIS A373325 counts them without heights.
TEST(PlanarPData, AreAsManyAsPublished) {
  const std::vector<uint64_t> codes = {1, 2, 10, 66, 498, 4072};
  uint64_t all = 0, expected = 0;
  ForEachPlanarPDataTo(5, [&](const knot::PData&) { ++all; });
  for (size_t n = 0; n < codes.size(); ++n) expected += codes[n] << n;
  EXPECT_EQ(all, expected);
}

}  // namespace
}  // namespace tact::enumerators

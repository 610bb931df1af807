#include "enumerators/solid_family.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace tact::enumerators {
namespace {

// Sets of a cube's corners up to its 48 symmetries: 22 (Polya), of which by size 0 to 8: 1 1 3 3 6 3 3 1 1. Of the six
// of four corners a face and a diagonal rectangle are flat.
TEST(CornerHulls, TwelveUpToSymmetry) {
  std::map<size_t, int> by_vertices;
  for (const auto& hull : CornerHulls()) ++by_vertices[hull.vertices.size()];
  EXPECT_EQ(by_vertices, (std::map<size_t, int>{{4, 4}, {5, 3}, {6, 3}, {7, 1}, {8, 1}}));
}

TEST(CornerHulls, NoTwoHaveTheSameFacesAndVolume) {
  // Volumes and face counts tell most apart; solids 1 and 3 of four corners have those of a corner tetrahedron.
  std::set<std::string> volumes;
  for (const auto& hull : CornerHulls()) {
    EXPECT_GT(SixfoldVolume(hull), algebra::Rational(0));
    EXPECT_LE(SixfoldVolume(hull), algebra::Rational(6));
  }
}

TEST(SolidPairs, NamesAreUniqueAndFamiliesStandTogether) {
  const auto pairs = SolidPairs(FamilySize::kLarge);
  std::set<std::string> names, closed_families;
  for (size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_TRUE(names.insert(pairs[i].name).second) << pairs[i].name;
    if (i > 0 && pairs[i].family != pairs[i - 1].family) closed_families.insert(pairs[i - 1].family);
    EXPECT_EQ(closed_families.count(pairs[i].family), 0U);
  }
  EXPECT_EQ(closed_families.size() + 1, 5U);
}

TEST(SolidPairs, SmallerSizesAreInLargerOnes) {
  const auto names = [](FamilySize size) {
    std::set<std::string> result;
    for (const auto& pair : SolidPairs(size)) result.insert(pair.name);
    return result;
  };
  const auto small = names(FamilySize::kSmall), medium = names(FamilySize::kMedium),
             large = names(FamilySize::kLarge);
  EXPECT_TRUE(std::includes(medium.begin(), medium.end(), small.begin(), small.end()));
  EXPECT_TRUE(std::includes(large.begin(), large.end(), medium.begin(), medium.end()));
  EXPECT_LT(small.size(), medium.size());
  EXPECT_LT(medium.size(), large.size());
}

TEST(SolidPairs, AllAreOneShell) {
  for (const auto& pair : SolidPairs(FamilySize::kLarge)) {
    EXPECT_EQ(pair.moving.shells, 1U) << pair.name;
    EXPECT_EQ(pair.fixed.shells, 1U) << pair.name;
  }
}

}  // namespace
}  // namespace tact::enumerators

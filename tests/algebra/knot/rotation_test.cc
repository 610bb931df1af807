#include "algebra/knot/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "algebra/knot/thesis_graphs.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

std::multiset<std::vector<int>> Edges(std::vector<std::vector<int>> faces) {
  std::multiset<std::vector<int>> sets;
  for (auto& face : faces) {
    for (int& dart : face) dart = std::abs(dart);
    std::sort(face.begin(), face.end());
    sets.insert(face);
  }
  return sets;
}

// Twin: faces traced without the end segments are those of faces.h with them.
TEST(Rotation, TracesTheFacesOfEveryPDataToThreeIntersections) {
  for (int c = 1; c <= 3; ++c) {
    ForEachPData(c, [](const PData& p) {
      EXPECT_EQ(Edges(TraceFaces(RotationOf(p))), Edges(KnotGraphFaces(p))) << p.ToJson();
      EXPECT_EQ(Genus(RotationOf(p)), Genus(p)) << p.ToJson();
      EXPECT_EQ(RotationOf(MirrorShape(p)), MirrorRotation(RotationOf(p)));
      EXPECT_TRUE(IsStraight(RotationOf(p)));
    });
  }
  EXPECT_EQ(Genus(RotationOf(PData())), 0);
}

// By hand: each of the two pairs of parallel edges may be exchanged, and the whole be mirrored: of 2 * 6 * 2 rotations
// four are planar. With just one pair exchanged the strands of the middle intersection, e1 e2 and e4 e5, go round
// corners.
TEST(Rotation, TheOverhandKnotsGraphHasFourPlanarRotationsAndTwoStraightOnes) {
  std::vector<Rotation> planar;
  ForEachPlanarRotation(kOverhand, [&](const Rotation& r) { planar.push_back(r); });
  ASSERT_EQ(planar.size(), 4u);
  EXPECT_EQ(std::count_if(planar.begin(), planar.end(), IsStraight), 2);
  EXPECT_EQ(std::count(planar.begin(), planar.end(), RotationOf(kOverhand)), 1);
  EXPECT_EQ(std::count(planar.begin(), planar.end(), MirrorRotation(RotationOf(kOverhand))), 1);
  // Without names all four look alike.
  for (const Rotation& r : planar) EXPECT_EQ(NamelessCode(r), NamelessCode(planar[0]));
}

TEST(Rotation, PlanarRotationsComeInMirrorPairs) {
  for (const PData& p : PlanarPData(3)) {
    std::set<Rotation> planar;
    ForEachPlanarRotation(p, [&](const Rotation& r) {
      EXPECT_EQ(Genus(r), 0);
      EXPECT_TRUE(planar.insert(r).second);
    });
    EXPECT_TRUE(planar.contains(RotationOf(p)));
    for (const Rotation& r : planar) EXPECT_TRUE(planar.contains(MirrorRotation(r)));
  }
}

TEST(Rotation, NamesDirectionsAndMirrorsDoNotShowInTheNamelessCode) {
  std::set<std::vector<int>> codes;
  for (const PData& p : PlanarPData(3)) {
    const auto code = NamelessCode(RotationOf(p));
    EXPECT_EQ(code, NamelessCode(RotationOf(EquivalentPData(p))));
    EXPECT_EQ(code, NamelessCode(RotationOf(MirrorShape(p))));
    codes.insert(code);
  }
  EXPECT_GT(codes.size(), 3u);
  EXPECT_FALSE(codes.contains(NamelessCode(RotationOf(PData({3, 4, 1, 2}, {3, 1, 4, 2})))));
}

}  // namespace
}  // namespace tact::knot

#include <gtest/gtest.h>

#include "tests/algebra/solid/solids.h"

namespace tact::algebra {
namespace {

constexpr size_t kNone = SoupDefect::kNone;

PolygonSoup Cube() { return Box({0, 0, 0}, {2, 2, 2}); }

// The polygon that is refused and a part of why.
void ExpectRefused(const PolygonSoup& soup, size_t polygon, const std::string& part) {
  size_t refused = kNone - 1;
  const std::string what = Refusal(soup, &refused);
  EXPECT_NE(what.find(part), std::string::npos) << "refused for: \"" << what << "\", expected: " << part;
  EXPECT_EQ(refused, polygon) << what;
}

TEST(PolyhedronRefusal, NoPolygons) { ExpectRefused({}, kNone, "no polygon"); }

TEST(PolyhedronRefusal, FewerThanThreeCorners) {
  PolygonSoup cube = Cube();
  cube.polygons.push_back({0, 1});
  ExpectRefused(cube, 6, "it has 2 corners, expected 3 or more");
}

TEST(PolyhedronRefusal, AnIndexBeyondThePoints) {
  PolygonSoup cube = Cube();
  cube.polygons[3][1] = 8;
  ExpectRefused(cube, 3, "it refers to point 8 (counting from 0), but there are only 8 points");
}

TEST(PolyhedronRefusal, RepeatedCorners) {
  PolygonSoup cube = Cube();
  cube.polygons[1].push_back(4);
  ExpectRefused(cube, 1, "corner (0, 0, 2) occurs twice");
}

TEST(PolyhedronRefusal, RepeatedCornersThatOnlyHaveEqualCoordinates) {
  PolygonSoup cube = Cube();
  cube.points.push_back({0, 0, 2});
  cube.polygons[1].push_back(8);
  ExpectRefused(cube, 1, "corner (0, 0, 2) occurs twice");
}

TEST(PolyhedronRefusal, CornersOnOneLine) {
  PolygonSoup cube = Cube();
  cube.points.push_back({1, 0, 0});
  cube.polygons.push_back({0, 8, 1});
  ExpectRefused(cube, 6, "its corners lie on one line, through (0, 0, 0) and (1, 0, 0), so it has zero area");
}

TEST(PolyhedronRefusal, ABowTieOfZeroArea) {
  PolygonSoup cube = Cube();
  cube.polygons[4] = {0, 4, 2, 6};
  ExpectRefused(cube, 4, "its boundary crosses itself and encloses zero area");
}

TEST(PolyhedronRefusal, ANonPlanarPolygonAndHowFarItIsOff) {
  PolygonSoup cube = Cube();
  cube.points[7] = {2, 2, Rational(201, 100)};
  ExpectRefused(cube, 1,
                "it is not planar: corner (0, 2, 2) is 0.00999988 off the plane through (0, 0, 2), (2, 0, 2) "
                "and (2, 2, 2.01)");
}

TEST(PolyhedronRefusal, AnOpenSurface) {
  PolygonSoup cube = Cube();
  cube.polygons.erase(cube.polygons.begin() + 1);
  ExpectRefused(cube, 1, "the edge from (2, 0, 2) to (0, 0, 2) has no second polygon");
  ExpectRefused(cube, 1, "the surface is open");
}

TEST(PolyhedronRefusal, AFlippedPolygon) {
  PolygonSoup cube = Cube();
  cube.polygons[5] = {cube.polygons[5].rbegin(), cube.polygons[5].rend()};
  ExpectRefused(cube, 0, "is run in the same direction by face 6, so one of the two is flipped");
}

TEST(PolyhedronRefusal, AnEdgeOfThreePolygons) {
  PolygonSoup cube = Cube();
  cube.points.push_back({1, 1, 1});
  cube.polygons.push_back({0, 1, 8});
  ExpectRefused(cube, 0, "is shared by 3 polygons, also by face 3, face 7");
}

// Two cubes that share an edge and its points: which polygons belong together is anybody's guess.
TEST(PolyhedronRefusal, AnEdgeOfFourPolygonsOnSharedPoints) {
  PolygonSoup cubes = Cube() + Box({2, 2, 0}, {3, 3, 2});
  for (auto& polygon : cubes.polygons) {
    for (size_t& corner : polygon) {
      for (size_t i = 0; i < 8; ++i) {
        if (cubes.points[i] == cubes.points[corner]) corner = i;
      }
    }
  }
  ExpectRefused(cubes, 3, "is shared by 4 polygons");
}

TEST(PolyhedronRefusal, ThePolygonTwice) {
  PolygonSoup cube = Cube();
  cube.polygons.push_back(cube.polygons[0]);
  ExpectRefused(cube, 0, "is shared by 3 polygons");
}

TEST(PolyhedronRefusal, AnInvertedShell) {
  ExpectRefused(Reversed(Cube()), 0, "inverted");
  ExpectRefused(Cube() + Moved(Reversed(Cube()), {5, 0, 0}), 6, "inverted");
}

TEST(PolyhedronRefusal, ACavityThatTouchesTheOutside) {
  for (const Vector3& low : {Vector3{0, 1, 1}, Vector3{0, 0, 1}, Vector3{0, 0, 0}, Vector3{1, 1, 3}}) {
    ExpectRefused(Box({0, 0, 0}, {4, 4, 4}) + Reversed(Box(low, low + Vector3{1, 1, 1})), 6,
                  "expected a cavity strictly inside one solid");
  }
}

TEST(PolyhedronRefusal, ACavityInACavity) {
  ExpectRefused(
      Box({0, 0, 0}, {9, 9, 9}) + Reversed(Box({1, 1, 1}, {8, 8, 8})) + Reversed(Box({3, 3, 3}, {4, 4, 4})),
      12, "inverted");
}

TEST(PolyhedronRefusal, APillowOfTwoPolygons) {
  const PolygonSoup pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  ExpectRefused(pillow, 0, "it is folded onto face 2");
}

TEST(PolyhedronRefusal, AFinOfZeroThickness) {
  PolygonSoup cube = Cube();  // the edge of polygons 1 and 2 drawn out into a fin
  cube.points.push_back({1, -1, 2});
  cube.polygons.push_back({4, 8, 5});
  cube.polygons.push_back({5, 8, 4});
  EXPECT_NE(Refusal(cube), "");
}

// A spike of the top's middle that pierces the bottom.
TEST(PolyhedronRefusal, ASelfIntersectionAndWhere) {
  PolygonSoup cube = Triangulated(Cube());
  cube.points.push_back({1, 1, -3});
  const std::vector<std::vector<size_t>> spike = {{4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}};
  cube.polygons.erase(cube.polygons.begin() + 2, cube.polygons.begin() + 4);
  cube.polygons.insert(cube.polygons.end(), spike.begin(), spike.end());
  const std::string what = Refusal(cube);
  EXPECT_NE(what.find("the surface meets itself at ("), std::string::npos) << what;
}

// The spike ends on the bottom exactly: a touch within one shell.
TEST(PolyhedronRefusal, AShellThatTouchesItself) {
  PolygonSoup cube = Triangulated(Cube());
  cube.points.push_back({1, Rational(1, 2), 0});
  cube.polygons.erase(cube.polygons.begin() + 2, cube.polygons.begin() + 4);
  for (const auto& side : {std::vector<size_t>{4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}}) {
    cube.polygons.push_back(side);
  }
  const std::string what = Refusal(cube);
  EXPECT_NE(what.find("the surface meets itself at (1, 0.5, 0)"), std::string::npos) << what;
}

TEST(PolyhedronRefusal, APolygonThatCrossesItself) {
  // A pentagram's outline encloses area, but crosses itself.
  const PolygonSoup star = Prism({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}, 0, 1);
  EXPECT_NE(Refusal(Reversed(star)).find("the surface meets itself"), std::string::npos);
  EXPECT_NE(Refusal(star).find("the surface meets itself"), std::string::npos);
}

TEST(PolyhedronRefusal, APolygonThatRunsBackOnItself) {
  const PolygonSoup spiked = Prism({{0, 0}, {4, 0}, {2, 0}, {2, 3}}, 0, 1);
  EXPECT_NE(Refusal(spiked), "");
}

TEST(PolyhedronRefusal, BodiesThatOverlap) {
  const PolygonSoup cube = Cube();
  ExpectRefused(cube + cube, 0, "overlap");                       // the same body twice
  ExpectRefused(cube + Moved(cube, {1, 1, 1}), 0, "overlap");     // corners in one another
  ExpectRefused(cube + Moved(cube, {1, 0, 0}), 0, "overlap");     // flush sides
  ExpectRefused(cube + Box({0, 0, 0}, {1, 1, 1}), 0, "overlap");  // within, flush
  ExpectRefused(cube + Box({0, 0, 0}, {3, 3, 3}), 0, "overlap");  // around, flush
  ExpectRefused(cube + Box({-1, Rational(1, 2), Rational(1, 2)}, {3, 1, 1}), 0,
                "overlap");  // a bar through it
  ExpectRefused(cube + Box({Rational(1, 2), Rational(1, 2), Rational(1, 2)}, {1, 1, 1}), 6,
                "lies inside another solid");
  // No edge of one is inside the other; only the faces' insides are.
  ExpectRefused(cube + Box({0, 0, -1}, {2, 2, 1}), 0, "overlap");
}

// A tetrahedron whose tip touches the cube's face from outside is fine, from inside it is not.
TEST(PolyhedronRefusal, ATipThatTouchesFromWithin) {
  PolygonSoup tip{{{2, 1, 1}, {4, 0, 0}, {4, 2, 0}, {4, 1, 2}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_EQ(Refusal(Cube() + tip), "");
  for (Vector3& p : tip.points) p.x = Rational(2) - (p.x - 2) * Rational(1, 2);
  EXPECT_NE(Refusal(Cube() + Reversed(tip)).find("overlap"), std::string::npos);
}

}  // namespace
}  // namespace tact::algebra

#include "algebra/solid/half_space_polytope.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>

#include "algebra/error.h"
#include "algebra/solid/convex_hull.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

using HalfSpaces = std::vector<std::pair<Vector3, Rational>>;

const HalfSpaces kBox = {{{1, 0, 0}, 3},  {{-2, 0, 0}, 0}, {{0, 1, 0}, 2},
                         {{0, -1, 0}, 0}, {{0, 0, 3}, 3},  {{0, 0, -1}, 0}};

TEST(HalfSpacePolytope, OfSixHalfSpacesIsTheBox) {
  const PolygonSoup box = HalfSpacePolytope(kBox);
  EXPECT_EQ(box.points.size(), 8u);
  EXPECT_EQ(box.polygons.size(), 6u);
  EXPECT_EQ(SixfoldVolume(BuildPolyhedron(box)), Rational(36));
}

TEST(HalfSpacePolytope, RedundantHalfSpacesAndTheOrderChangeNothing) {
  const PolygonSoup box = HalfSpacePolytope(kBox);
  HalfSpaces more(kBox.rbegin(), kBox.rend());
  more.push_back({{1, 1, 1}, 6});  // through one corner
  more.push_back({{1, 0, 0}, 7});
  more.push_back({{5, 0, 0}, 15});
  const PolygonSoup same = HalfSpacePolytope(more);
  EXPECT_EQ(same.points, box.points);
  EXPECT_EQ(same.polygons, box.polygons);
}

std::string Refusal(const HalfSpaces& half_spaces) {
  try {
    HalfSpacePolytope(half_spaces);
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return "";
}

TEST(HalfSpacePolytope, WhatIsNoSolidIsRefusedAndNamed) {
  HalfSpaces empty = kBox, flat = kBox, point = kBox, zero = kBox;
  empty.push_back({{1, 1, 1}, -1});
  flat.push_back({{0, 0, 1}, 0});
  point.push_back({{1, 1, 1}, 0});
  zero.push_back({{0, 0, 0}, 1});
  const HalfSpaces quadrant(kBox.begin(), kBox.begin() + 4);
  const HalfSpaces apart = {{{1, 0, 0}, 0}, {{-1, 0, 0}, -1}};  // empty, of a cone with lines
  EXPECT_NE(Refusal(empty).find("common point"), std::string::npos);
  EXPECT_NE(Refusal(apart).find("common point"), std::string::npos);
  EXPECT_NE(Refusal(flat).find("dimension 2"), std::string::npos);
  EXPECT_NE(Refusal(point).find("dimension 0"), std::string::npos);
  EXPECT_NE(Refusal(quadrant).find("bounded"), std::string::npos);
  EXPECT_NE(Refusal({}).find("bounded"), std::string::npos);
  EXPECT_NE(Refusal(zero).find("not zero"), std::string::npos);
}

RC_GTEST_PROP(HalfSpacePolytope, OfTheFacesOfAHullIsTheHull, ()) {
  std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int more = Uniform(0, 9);
  for (int i = 0; i < more; ++i) {
    const auto coordinate = [] { return Rational(Uniform(-4, 5)) / Rational(Uniform(1, 4)); };
    points.push_back({coordinate(), coordinate(), coordinate()});
  }
  const PolygonSoup hull = ConvexHull(points);
  HalfSpaces half_spaces;
  for (const Face& face : BuildPolyhedron(hull).faces) half_spaces.emplace_back(face.normal, face.offset);
  RC_ASSERT(half_spaces.size() == hull.polygons.size());
  const PolygonSoup back = HalfSpacePolytope(half_spaces);
  RC_ASSERT(std::set<Vector3>(back.points.begin(), back.points.end()) ==
            std::set<Vector3>(hull.points.begin(), hull.points.end()));
  RC_ASSERT(back.polygons.size() == hull.polygons.size());
  RC_ASSERT(SixfoldVolume(BuildPolyhedron(back)) == SixfoldVolume(BuildPolyhedron(hull)));
}

}  // namespace
}  // namespace tact::algebra

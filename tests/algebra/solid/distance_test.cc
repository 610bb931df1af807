#include "algebra/solid/distance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/solid/point_locator.h"
#include "tests/algebra/solid/solids.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

Vector3 SmallPoint() { return {Uniform(-4, 5), Uniform(-4, 5), Uniform(-4, 5)}; }

const Face& FaceWithNormal(const Polyhedron& solid, const Vector3& normal) {
  for (const Face& face : solid.faces) {
    if (face.normal == normal) return face;
  }
  throw InvariantError("no such face");
}

TEST(Distance, NearestOnSegmentStopsAtItsEnds) {
  const Vector3 a{0, 0, 0}, b{4, 0, 0};
  EXPECT_EQ(NearestOnSegment({1, 5, 0}, a, b).point, (Vector3{1, 0, 0}));
  EXPECT_EQ(NearestOnSegment({1, 5, 0}, a, b).parameter, Rational(1, 4));
  EXPECT_EQ(NearestOnSegment({-1, 5, 0}, a, b).point, a);
  EXPECT_EQ(NearestOnSegment({9, 5, 2}, a, b).point, b);
}

TEST(Distance, CrossingSegmentsAreNearestWhereTheyCross) {
  const SegmentPair pair = NearestOnSegments({-1, 0, 0}, {1, 0, 0}, {0, -3, 2}, {0, 1, 2});
  EXPECT_EQ(pair.first.point, (Vector3{0, 0, 0}));
  EXPECT_EQ(pair.second.point, (Vector3{0, 0, 2}));
  EXPECT_EQ(pair.first.parameter, Rational(1, 2));
  EXPECT_EQ(pair.second.parameter, Rational(3, 4));
}

// Nearest means: moving either point along its segment either way does not come nearer, and distance is convex.
RC_GTEST_PROP(DistanceLaw, NearestPointsOfSegmentsAreNearest, ()) {
  const Vector3 a = SmallPoint(), b = SmallPoint(), c = SmallPoint(), d = SmallPoint();
  RC_PRE(!Parallel(b - a, d - c));
  const SegmentPair pair = NearestOnSegments(a, b, c, d);
  const auto at = [](const Vector3& p, const Vector3& q, const Rational& t) { return p + t * (q - p); };
  RC_ASSERT(pair.first.point == at(a, b, pair.first.parameter));
  RC_ASSERT(pair.second.point == at(c, d, pair.second.parameter));
  const Rational least = SquaredDistance(pair.first.point, pair.second.point);
  RC_ASSERT(SquaredDistance(pair.first.point, NearestOnSegment(pair.first.point, c, d).point) == least);
  RC_ASSERT(SquaredDistance(pair.second.point, NearestOnSegment(pair.second.point, a, b).point) == least);
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      RC_ASSERT(least <= SquaredDistance(at(a, b, Rational(i, 8)), at(c, d, Rational(j, 8))));
    }
  }
}

TEST(Distance, FaceWithAHoleContainsItsRimsAndNotTheHole) {
  const Polyhedron plate = BuildPolyhedron(PlateWithHole());
  const Face& top = FaceWithNormal(plate, {0, 0, 1});
  ASSERT_EQ(top.loops.size(), 2u);
  for (int x = -2; x <= 14; ++x) {
    for (int y = -2; y <= 14; ++y) {
      const bool in_plate = x >= 0 && x <= 12 && y >= 0 && y <= 12;
      const bool in_hole = x > 4 && x < 8 && y > 4 && y < 8;
      EXPECT_EQ(FaceContains(plate, top, {Rational(x, 2), Rational(y, 2), 2}), in_plate && !in_hole)
          << x << " " << y;
    }
  }
}

TEST(Distance, ToAFaceWithAHole) {
  const Polyhedron plate = BuildPolyhedron(PlateWithHole());
  const Face& top = FaceWithNormal(plate, {0, 0, 1});
  EXPECT_EQ(ProjectOntoPlane({1, 1, 7}, top), (Vector3{1, 1, 2}));
  EXPECT_EQ(SquaredDistanceToFace(plate, top, {1, 1, 7}), Rational(25));    // above the face
  EXPECT_EQ(SquaredDistanceToFace(plate, top, {3, 3, 2}), Rational(1));     // in the hole: to its rim
  EXPECT_EQ(SquaredDistanceToFace(plate, top, {3, 3, 4}), Rational(5));     // above the hole
  EXPECT_EQ(SquaredDistanceToFace(plate, top, {-3, -4, 2}), Rational(25));  // to a corner
  EXPECT_EQ(SquaredDistanceToFace(plate, top, {3, -2, 3}), Rational(5));    // to an edge
  EXPECT_EQ(SquaredDistanceToFace(plate, top, {4, 3, 2}), Rational(0));     // on the rim
  EXPECT_EQ(PointLocator(plate).SquaredDistanceToSurface({1, 1, Rational(1, 2)}, 0), Rational(1, 4));
  EXPECT_EQ(PointLocator(plate).SquaredDistanceToSurface({3, 3, 1}, 0), Rational(1));
}

// By hand: the distance to a box is that of what sticks out along each axis.
RC_GTEST_PROP(DistanceLaw, ToABoxFromOutside, ()) {
  const Polyhedron box = BuildPolyhedron(Box({-1, -2, 0}, {2, 1, 1}));
  const Vector3 low{-1, -2, 0}, high{2, 1, 1}, p = SmallPoint();
  RC_PRE(Locate(box, p) != Side::kInside);
  Rational expected(0);
  for (int i = 0; i < 3; ++i) {
    const Rational out = std::max({low[i] - p[i], p[i] - high[i], Rational(0)});
    expected += out * out;
  }
  RC_ASSERT(PointLocator(box).SquaredDistanceToSurface(p, -1) == expected);
}

// Leaving faces out changes nothing, inside or outside; what is near enough is only said to be.
RC_GTEST_PROP(DistanceLaw, ToASurfaceIsToItsNearestFace, ()) {
  const Polyhedron plate = BuildPolyhedron(PlateWithHole());
  const PointLocator locator(plate);
  const Vector3 p = Rational(1, 2) * Vector3{Uniform(-4, 17), Uniform(-4, 17), Uniform(-4, 9)};
  Rational least = SquaredDistanceToFace(plate, plate.faces[0], p);
  for (const Face& face : plate.faces) least = std::min(least, SquaredDistanceToFace(plate, face, p));
  RC_ASSERT(locator.SquaredDistanceToSurface(p, -1) == least);
  const Rational enough(Uniform(0, 12)), found = locator.SquaredDistanceToSurface(p, enough);
  RC_ASSERT((least > enough ? found == least : found <= enough));
  RC_ASSERT(locator.Locate(p) == Locate(plate, p));
}

}  // namespace
}  // namespace tact::algebra

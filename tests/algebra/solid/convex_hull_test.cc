#include "algebra/solid/convex_hull.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <utility>

#include "algebra/error.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

using Points = std::vector<Vector3>;

const Points kCube = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};

// The faces as sets of points.
std::set<std::set<Vector3>> FaceSets(const PolygonSoup& soup) {
  std::set<std::set<Vector3>> faces;
  for (const auto& polygon : soup.polygons) {
    std::set<Vector3> corners;
    for (const size_t i : polygon) corners.insert(soup.points.at(i));
    faces.insert(std::move(corners));
  }
  return faces;
}

Rational Volume6(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return Dot(Cross(b - a, c - a), d - a);
}

// By definition: every plane through three of the points that has none on its outer side, with the corners
// of the points on it, which are those that lie on no segment and in no triangle of the others.
std::set<std::set<Vector3>> BruteForceFaces(const Points& given) {
  const std::set<Vector3> distinct(given.begin(), given.end());
  const Points points(distinct.begin(), distinct.end());
  std::set<std::set<Vector3>> faces;
  for (const Vector3& a : points) {
    for (const Vector3& b : points) {
      for (const Vector3& c : points) {
        const Vector3 normal = Cross(b - a, c - a);
        if (normal.IsZero()) continue;
        Points on;
        bool outermost = true;
        for (const Vector3& p : points) {
          const int side = Volume6(a, b, c, p).sign();
          outermost = outermost && side <= 0;
          if (side == 0) on.push_back(p);
        }
        if (!outermost) continue;
        std::set<Vector3> corners;
        for (const Vector3& p : on) {
          bool corner = true;
          for (const Vector3& q : on) {
            for (const Vector3& r : on) {
              if (p == q || p == r || q == r) continue;
              if (Parallel(q - p, r - p) && Dot(q - p, r - p).sign() < 0) corner = false;
              for (const Vector3& s : on) {
                if (s == p || s == q || s == r) continue;
                const auto turn = [&](const Vector3& u, const Vector3& v) {
                  return Dot(normal, Cross(u - p, v - p)).sign();
                };
                if (turn(q, r) > 0 && turn(r, s) > 0 && turn(s, q) > 0) corner = false;
              }
            }
          }
          if (corner) corners.insert(p);
        }
        faces.insert(corners);
      }
    }
  }
  return faces;
}

TEST(ConvexHull, OfACubeWithPointsInsideOnFacesAndOnEdgesIsTheCube) {
  Points points = {{1, 1, 1}, {1, 1, 0}, {1, 0, 0}, {2, 1, 1}};
  points.insert(points.end(), kCube.begin(), kCube.end());
  points.push_back({0, 0, 1});
  points.push_back(kCube.front());
  const PolygonSoup hull = ConvexHull(points);
  EXPECT_EQ(hull.points, kCube);  // in the order given
  ASSERT_EQ(hull.polygons.size(), 6u);
  const Polyhedron cube = BuildPolyhedron(hull);
  EXPECT_EQ(SixfoldVolume(cube), Rational(48));
  EXPECT_EQ(cube.edges.size(), 12u);
}

TEST(ConvexHull, OfSixPointsOnTheAxesIsTheOctahedron) {
  const Points axes = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const PolygonSoup hull = ConvexHull(axes);
  EXPECT_EQ(hull.points, axes);
  ASSERT_EQ(hull.polygons.size(), 8u);
  for (const auto& polygon : hull.polygons) {
    ASSERT_EQ(polygon.size(), 3u);
    const Vector3 &a = axes[polygon[0]], &b = axes[polygon[1]], &c = axes[polygon[2]];
    EXPECT_GT(Dot(Cross(b - a, c - a), a + b + c), Rational(0));  // counter-clockwise from outside
  }
}

TEST(ConvexHull, PointsInOnePlaneAreRefused) {
  EXPECT_THROW(ConvexHull({}), PreconditionError);
  EXPECT_THROW(ConvexHull({{1, 2, 3}}), PreconditionError);
  EXPECT_THROW(ConvexHull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), PreconditionError);
  EXPECT_THROW(ConvexHull({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {3, 7, 1}}), PreconditionError);
}

TEST(ConvexHull, OfFortyPointsInConvexPositionHasThemAll) {
  // On the moment curve every two corners share an edge; 40 corners make 2 * 40 - 4 triangles.
  Points points;
  for (int t = -20; t < 20; ++t) points.push_back({t, t * t, t * t * t});
  const PolygonSoup hull = ConvexHull(points);
  EXPECT_EQ(hull.points, points);
  EXPECT_EQ(hull.polygons.size(), 76u);
}

RC_GTEST_PROP(ConvexHull, IsWhatBruteForceFinds, ()) {
  const int size = Uniform(4, 9), range = Uniform(1, 4), denominator = Uniform(1, 3);
  Points points;
  for (int i = 0; i < size; ++i) {
    const auto coordinate = [&] { return Rational(Uniform(-range, range + 1)) / Rational(denominator); };
    points.push_back({coordinate(), coordinate(), coordinate()});
  }
  bool flat = true;
  for (const Vector3& a : points) {
    for (const Vector3& b : points) {
      for (const Vector3& c : points) flat = flat && Volume6(points.front(), a, b, c).sign() == 0;
    }
  }
  if (flat) {
    RC_ASSERT_THROWS_AS(ConvexHull(points), PreconditionError);
    return;
  }
  const PolygonSoup hull = ConvexHull(points);
  RC_ASSERT(FaceSets(hull) == BruteForceFaces(points));
  RC_ASSERT(hull.polygons.size() == FaceSets(hull).size());
  const Polyhedron solid = BuildPolyhedron(hull);  // closed and turned outwards, or it throws
  RC_ASSERT(SixfoldVolume(solid).sign() > 0);
  RC_ASSERT(solid.vertices.size() == hull.points.size());
  for (const Vector3& p : points) RC_ASSERT(Locate(solid, p) != Side::kOutside);
}

}  // namespace
}  // namespace tact::algebra

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "tests/algebra/solid/solids.h"

namespace tact::algebra {
namespace {

// Checks every point of a grid of step 1/2 against a membership test of the closed solid and one of its
// interior.
void ExpectAgreesOnGrid(const Polyhedron& solid, int low, int high,
                        const std::function<Side(const Vector3&)>& expected) {
  for (int i = 2 * low; i <= 2 * high; ++i) {
    for (int j = 2 * low; j <= 2 * high; ++j) {
      for (int k = 2 * low; k <= 2 * high; ++k) {
        const Vector3 p{Rational(i, 2), Rational(j, 2), Rational(k, 2)};
        ASSERT_EQ(Locate(solid, p), expected(p)) << ToString(p);
      }
    }
  }
}

Side InBox(const Vector3& low, const Vector3& high, const Vector3& p) {
  bool strictly = true;
  for (int i = 0; i < 3; ++i) {
    if (p[i] < low[i] || high[i] < p[i]) return Side::kOutside;
    strictly = strictly && low[i] < p[i] && p[i] < high[i];
  }
  return strictly ? Side::kInside : Side::kOnBoundary;
}

Side Opposite(Side side) {
  return side == Side::kInside ? Side::kOutside : (side == Side::kOutside ? Side::kInside : side);
}

Side Intersection(Side a, Side b) {
  if (a == Side::kOutside || b == Side::kOutside) return Side::kOutside;
  return a == Side::kInside ? b : a;
}

TEST(Locate, PlateWithHoleOnAGrid) {
  ExpectAgreesOnGrid(BuildPolyhedron(PlateWithHole()), -1, 7, [](const Vector3& p) {
    return Intersection(InBox({0, 0, 0}, {6, 6, 2}, p), Opposite(InBox({2, 2, -9}, {4, 4, 9}, p)));
  });
}

TEST(Locate, CavityOnAGrid) {
  ExpectAgreesOnGrid(
      BuildPolyhedron(Box({0, 0, 0}, {4, 4, 4}) + Reversed(Box({1, 1, 1}, {3, 2, 3}))), -1, 5,
      [](const Vector3& p) {
        return Intersection(InBox({0, 0, 0}, {4, 4, 4}, p), Opposite(InBox({1, 1, 1}, {3, 2, 3}, p)));
      });
}

// Where bodies touch, points that both together surround are inside.
TEST(Locate, TouchingBodiesOnAGridAreTheirUnion) {
  const Polyhedron solid = BuildPolyhedron(Box({0, 0, 0}, {4, 4, 2}) + Box({1, 1, 2}, {3, 4, 4}));
  ExpectAgreesOnGrid(solid, -1, 5, [](const Vector3& p) {
    const Side base = InBox({0, 0, 0}, {4, 4, 2}, p), top = InBox({1, 1, 2}, {3, 4, 4}, p);
    if (base == Side::kInside || top == Side::kInside) return Side::kInside;
    // The common face without its rim.
    const bool between = p.z == Rational(2) && p.x > Rational(1) && p.x < Rational(3) && p.y > Rational(1) &&
                         p.y < Rational(4);
    if (between) return Side::kInside;
    return base == Side::kOutside ? top : base;
  });
}

// Eight cubes around one corner: the corner, edges and faces between them are inside.
TEST(Locate, BodiesThatSurroundAPointHoldIt) {
  PolygonSoup cubes;
  for (int i = 0; i < 8; ++i) {
    const Vector3 low{i & 1 ? 0 : -1, i & 2 ? 0 : -1, i & 4 ? 0 : -1};
    cubes = cubes + Box(low, low + Vector3{1, 1, 1});
  }
  const Polyhedron solid = BuildPolyhedron(cubes);
  EXPECT_EQ(solid.shells, 8u);
  ExpectAgreesOnGrid(solid, -2, 2, [](const Vector3& p) { return InBox({-1, -1, -1}, {1, 1, 1}, p); });
}

// A tetrahedron by its four planes.
RC_GTEST_PROP(LocateLaw, TetrahedraAgreeWithTheirHalfSpaces, ()) {
  PolygonSoup soup;
  for (int i = 0; i < 4; ++i) {
    soup.points.push_back({*rc::gen::inRange(-4, 5), *rc::gen::inRange(-4, 5), *rc::gen::inRange(-4, 5)});
  }
  soup.polygons = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Vector3& o = soup.points[0];
  const int sign = Dot(Cross(soup.points[1] - o, soup.points[2] - o), soup.points[3] - o).sign();
  RC_PRE(sign != 0);
  const Polyhedron solid = BuildPolyhedron(sign > 0 ? soup : Reversed(soup));
  for (int i = 0; i < 20; ++i) {
    const Vector3 p{Rational(*rc::gen::inRange(-8, 9), 2), Rational(*rc::gen::inRange(-8, 9), 2),
                    *rc::gen::inRange(-4, 5)};
    Side expected = Side::kInside;
    for (const Face& face : solid.faces) {
      const int height = (Dot(face.normal, p) - face.offset).sign();
      const Side side = height < 0 ? Side::kInside : (height == 0 ? Side::kOnBoundary : Side::kOutside);
      expected = Intersection(expected, side);
    }
    RC_ASSERT(Locate(solid, p) == expected);
  }
}

}  // namespace
}  // namespace tact::algebra

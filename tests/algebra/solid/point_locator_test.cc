#include "algebra/solid/point_locator.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "algebra/solid/distance.h"
#include "tests/algebra/solid/solids.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

// Below every squared distance: the exact value is asked for.
const Rational kAnything(-1);

Vector3 AnyPoint() {
  Vector3 p;
  for (int k = 0; k < 3; ++k) p[k] = Rational(Integer(Uniform(-12, 12)), Integer(Uniform(1, 4)));
  return p;
}

// By hand: the distance to a box from outside is that of what sticks out along each axis, from inside that to the
// nearest side.
RC_GTEST_PROP(PointLocatorLaw, DistanceToABox, ()) {
  const Polyhedron box = BuildPolyhedron(Triangulated(Box({-1, -2, 0}, {2, 1, 1})));
  const PointLocator locator(box);
  const Vector3 low{-1, -2, 0}, high{2, 1, 1}, p = AnyPoint();
  Rational out(0), in(100);
  for (int i = 0; i < 3; ++i) {
    const Rational over = std::max({low[i] - p[i], p[i] - high[i], Rational(0)});
    out += over * over;
    in = std::min({in, p[i] - low[i], high[i] - p[i]});
  }
  const Rational expected = in.sign() > 0 ? in * in : out;
  RC_ASSERT(locator.SquaredDistanceToSurface(p, kAnything) == expected);
  // Told that more than that is all we care for, it need not be exact but must not say more.
  RC_ASSERT(locator.SquaredDistanceToSurface(p, expected) <= expected);
  RC_ASSERT((locator.Locate(p) == Side::kInside) == (in.sign() > 0));
  RC_ASSERT((locator.Locate(p) == Side::kOutside) == (out.sign() > 0));
}

// By hand: in a plate with a hole the nearest surface is the top, and in the hole its walls.
TEST(PointLocator, KnowsHoles) {
  const Polyhedron frame = BuildPolyhedron(Box({0, 0, 0}, {9, 9, 9}) + Reversed(Box({2, 2, 2}, {7, 7, 7})));
  const PointLocator locator(frame);
  EXPECT_EQ(locator.Locate({1, 4, 4}), Side::kInside);
  EXPECT_EQ(locator.Locate({4, 4, 4}), Side::kOutside);
  EXPECT_EQ(locator.Locate({2, 4, 4}), Side::kOnBoundary);
  EXPECT_EQ(locator.SquaredDistanceToSurface({3, 4, 4}, kAnything), Rational(1));
}

// Leaving faces out changes nothing, inside or outside; what is near enough is only said to be.
RC_GTEST_PROP(PointLocatorLaw, TheNearestFaceIsFound, ()) {
  const Polyhedron plate = BuildPolyhedron(PlateWithHole());
  const PointLocator locator(plate);
  const Vector3 p = Rational(1, 2) * Vector3{Uniform(-4, 17), Uniform(-4, 17), Uniform(-4, 9)};
  Rational least = SquaredDistanceToFace(plate, plate.faces[0], p);
  for (const Face& face : plate.faces) least = std::min(least, SquaredDistanceToFace(plate, face, p));
  RC_ASSERT(locator.SquaredDistanceToSurface(p, kAnything) == least);
  const Rational enough(Uniform(0, 12)), found = locator.SquaredDistanceToSurface(p, enough);
  RC_ASSERT((least > enough ? found == least : found <= enough));
}

}  // namespace
}  // namespace tact::algebra

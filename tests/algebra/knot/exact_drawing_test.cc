#include "algebra/knot/exact_drawing.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "algebra/knot/curve_views.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

using algebra::Rational;

Rational Area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void ExpectRoundTrip(const PData& p, int outer) {
  const auto read = ProjectCurve(DrawExactly(p, outer), ViewFromAbove());
  const auto* projection = std::get_if<CurveProjection>(&read);
  ASSERT_NE(projection, nullptr) << p.ToJson() << " face " << outer << ": "
                                 << std::get<CurveFault>(read).what();
  ASSERT_EQ(projection->p, p) << "face " << outer << ": " << projection->p.ToJson();
}

// Positive triangles within a convex polygon fill it once: that is an embedding, whatever made the coordinates.
void ExpectEmbedding(const PData& p, int outer) {
  const auto t = TriangulateDiagram(p, outer);
  const auto points = EmbedTriangulation(t);
  const auto at = [&](int v) { return points[static_cast<size_t>(v)]; };
  Rational filled, whole;
  for (const auto& [a, b, c] : t.triangles) {
    ASSERT_GT(Area(at(a), at(b), at(c)).sign(), 0) << p.ToJson();
    filled += Area(at(a), at(b), at(c));
  }
  const size_t corners = t.boundary.size();
  for (size_t k = 0; k < corners; ++k) {
    const PlanePoint a = at(t.boundary[k]), b = at(t.boundary[(k + 1) % corners]),
                     c = at(t.boundary[(k + 2) % corners]);
    ASSERT_LT(Area(a, b, c).sign(), 0) << "the ring is not convex";
    whole += b.x * a.y - a.x * b.y;
  }
  ASSERT_EQ(filled, whole);
}

TEST(ExactDrawing, TheStraightRopeAndLoopsAreDrawn) {
  ExpectRoundTrip(PData(), 0);
  for (int attr = 1; attr <= 4; ++attr) {
    for (const int outer : {0, 1}) ExpectRoundTrip(PData({2, 1}, {attr, MateAttribute(attr)}), outer);
  }
}

TEST(ExactDrawing, EveryPDataOfUpTo2ComesBackFromEachFaceOutside) {
  for (int n = 0; n <= 2; ++n) {
    for (const PData& p : PlanarPData(n)) {
      for (int outer = 0; outer <= n; ++outer) {
        ExpectEmbedding(p, outer);
        ExpectRoundTrip(p, outer);
      }
    }
  }
}

TEST(ExactDrawing, EveryPDataOf3ComesBack) {
  const auto all = PlanarPData(3);
  for (size_t k = 0; k < all.size(); ++k) ExpectRoundTrip(all[k], static_cast<int>(k % 4));
}

TEST(ExactDrawing, RandomRopesComeBack) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 60; ++k) {
    const PData p = RandomPData(random, 12 + static_cast<int>(random() % 19));
    ExpectRoundTrip(p, static_cast<int>(random() % static_cast<uint64_t>(p.crossings() + 1)));
  }
}

TEST(ExactDrawing, RandomRopesAreEmbedded) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 10; ++k) ExpectEmbedding(RandomPData(random, 12 + 2 * k), k % 3);
}

TEST(ExactDrawing, AMirrorComesBackAsAMirror) {
  const PData p({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]
  Curve curve = DrawExactly(p);
  for (algebra::Vector3& point : curve) point[0] = -point[0];
  const auto read = ProjectCurve(curve, ViewFromAbove());
  ASSERT_TRUE(std::holds_alternative<CurveProjection>(read));
  EXPECT_EQ(std::get<CurveProjection>(read).p, MirrorShape(p));
}

TEST(ExactDrawing, ATorusAndAFaceThatIsNoneAreRefused) {
  EXPECT_THROW(DrawExactly(PData({3, 4, 1, 2}, {3, 3, 4, 4})), PreconditionError);
  EXPECT_THROW(DrawExactly(PData(), 1), PreconditionError);
}

TEST(FullExactDrawing, EveryPDataOfUpTo4ComesBack) {
  for (int n = 0; n <= 4; ++n) {
    const auto all = PlanarPData(n);
    for (size_t k = 0; k < all.size(); ++k) ExpectRoundTrip(all[k], static_cast<int>(k) % (n + 1));
  }
}

TEST(FullExactDrawing, ManyRandomRopesComeBack) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 400; ++k) {
    const PData p = RandomPData(random, 12 + static_cast<int>(random() % 19));
    ExpectRoundTrip(p, static_cast<int>(random() % static_cast<uint64_t>(p.crossings() + 1)));
  }
}

}  // namespace
}  // namespace tact::knot

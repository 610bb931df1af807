#include "algebra/knot/curve_projection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>

#include "algebra/error.h"
#include "algebra/knot/faces.h"
#include "algebra/screw/pose.h"
#include "tests/algebra/knot/slow_projection.h"
#include "tests/algebra/uniform.h"

namespace tact::knot {
namespace {

using algebra::Integer;
using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;
using Kind = CurveFaultKind;

const Vector3 kAbove{0, 0, 1};

// Along the x axis, round above it, and three times across it: over, under, over.
const Curve kOverhand = {{-2, 0, 0}, {14, 0, 0}, {14, 8, 0}, {-4, 8, 0},
                         {-4, 2, 4}, {2, -2, 0}, {6, 2, -4}, {10, -2, 8}};

PData Seen(const Curve& curve, const Vector3& view = kAbove) {
  const auto projection = ProjectCurve(curve, view);
  if (const auto* fault = std::get_if<CurveFault>(&projection)) throw std::runtime_error(fault->what());
  return std::get<CurveProjection>(projection).p;
}

CurveFault Fault(const Curve& curve, const Vector3& view = kAbove) {
  return std::get<CurveFault>(ProjectCurve(curve, view));
}

Curve RandomCurve(int points, int extent) {
  Curve curve(static_cast<size_t>(points));
  for (Vector3& point : curve)
    for (int i = 0; i < 3; ++i) point[i] = Uniform(-extent, extent + 1);
  return curve;
}

Rotation RandomRotation() {
  const auto number = [] { return Rational(Uniform(-4, 5)); };
  const Rational w = number(), x = number(), y = number(), z = number();
  RC_PRE(w.sign() != 0 || x.sign() != 0 || y.sign() != 0 || z.sign() != 0);
  return Rotation::FromQuaternion(w, x, y, z);
}

// A curve that is seen without a fault from above.
Curve FairCurve() {
  Curve curve;
  do curve = RandomCurve(Uniform(2, 13), 60);
  while (std::holds_alternative<CurveFault>(ProjectCurve(curve, kAbove)));
  return curve;
}

// Followed by hand: the axis is under, over, under; (6,-4) x (1,0), (1,0) x (4,4) and (4,-4) x (1,0) are positive.
TEST(CurveProjection, AnOverhandKnotFollowedByHand) {
  EXPECT_EQ(Seen(kOverhand), PData({4, 5, 6, 1, 2, 3}, {4, 3, 4, 3, 4, 3}));
  const auto projection = std::get<CurveProjection>(ProjectCurve(kOverhand, kAbove));
  const std::vector<CurvePlace> places = {{1, Rational(1, 16)}, {1, Rational(6, 16)}, {1, Rational(10, 16)},
                                          {5, Rational(1, 2)},  {6, Rational(1, 2)},  {7, Rational(1, 2)}};
  EXPECT_EQ(projection.places, places);
}

TEST(CurveProjection, TwoPointsAreTheStraightRope) { EXPECT_EQ(Seen({{0, 0, 0}, {1, 2, 3}}), PData()); }

TEST(CurveProjection, EachFaultIsNamedWithItsPoints) {
  const auto expect = [](const Curve& curve, Kind kind, const std::vector<int>& points,
                         const std::string& what) {
    const CurveFault fault = Fault(curve);
    EXPECT_EQ(fault.kind, kind);
    EXPECT_EQ(fault.points, points);
    EXPECT_EQ(fault.what(), what);
  };
  expect({}, Kind::kTooFewPoints, {}, "expected two points or more, got fewer");
  expect({{1, 2, 3}}, Kind::kTooFewPoints, {}, "expected two points or more, got fewer");
  expect({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, Kind::kRepeatedPoint, {2, 3},
         "expected points that differ from those before them, got point 3 where point 2 is");
  expect({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, Kind::kClosed, {1, 4},
         "expected a rope with two ends, got a closed curve: point 4 is where point 1 is; without one of "
         "them it "
         "is cut open there");
  expect({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, -1, 0}}, Kind::kMeetsItself, {1, 2, 4, 5},
         "expected a rope that does not meet itself, got two edges with a point in common: that of points 1 "
         "and 2, "
         "that of points 4 and 5");
  expect({{0, 0, 0}, {2, 0, 2}, {1, 0, 1}}, Kind::kMeetsItself, {1, 2, 2, 3},
         "expected a rope that does not meet itself, got two edges with a point in common: that of points 1 "
         "and 2, "
         "that of points 2 and 3");
  expect({{0, 0, 0}, {1, 0, 0}, {1, 0, 5}, {1, 1, 0}}, Kind::kVerticalEdge, {2, 3},
         "expected edges that are seen as lines, got one along the view: that of points 2 and 3");
  expect(
      {{0, 0, 0}, {2, 0, 2}, {1, 0, 3}}, Kind::kOverlap, {1, 2, 2, 3},
      "expected edges that are seen to cross, got two that cover each other: that of points 1 and 2, that of "
      "points 2 and 3");
  // An end on a strand, which [thesis, 5.1.1] forbids.
  expect(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {2, 0, 1}}, Kind::kPointOnEdge, {4, 1, 2},
      "expected points that are seen beside the rope's other edges, got point 4 on an edge: that of points 1 "
      "and 2");
  expect({{-2, 0, 0}, {2, 0, 0}, {2, 2, 1}, {-2, -2, 1}, {-2, -3, 2}, {0, -3, 2}, {0, 3, 2}},
         Kind::kTriplePoint, {1, 2, 3, 4, 6, 7},
         "expected two edges to be seen at an intersection, got three: that of points 1 and 2, that of "
         "points 3 and "
         "4, that of points 6 and 7");
}

TEST(CurveProjection, MoreIntersectionsThanWantedAreRefused) {
  EXPECT_TRUE(std::holds_alternative<CurveProjection>(ProjectCurve(kOverhand, kAbove, 3)));
  EXPECT_EQ(std::get<CurveFault>(ProjectCurve(kOverhand, kAbove, 2)).kind, Kind::kTooManyIntersections);
}

// What no view mends is said first, and edges that only seem to cover each other are told from those that meet.
TEST(CurveProjection, FaultsOfTheCurveComeBeforeThoseOfTheView) {
  const Curve meets_behind_a_touch = {{0, 0, 0},  {4, 0, 0},  {4, 4, 1}, {2, 0, 1},
                                      {2, -1, 1}, {1, -1, 0}, {1, 1, 0}};
  EXPECT_EQ(Fault(meets_behind_a_touch).kind, Kind::kMeetsItself);
  EXPECT_EQ(Fault(meets_behind_a_touch).points, (std::vector<int>{1, 2, 6, 7}));
  EXPECT_EQ(Fault({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {3, 0, 1}, {1, 0, -1}}).kind, Kind::kMeetsItself);
  EXPECT_EQ(Fault({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {3, 0, 1}, {1, 0, 2}}).kind, Kind::kOverlap);
}

TEST(CurveProjection, AViewOfNoLengthIsRefused) {
  EXPECT_THROW(ProjectCurve(kOverhand, {0, 0, 0}), PreconditionError);
}

// Small grids make faults frequent, large ones rare; some views have coordinates that are zero.
TEST(CurveProjection, TheSlowWayFindsTheSameForTenThousandCurves) {
  std::mt19937_64 random(1);
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<uint64_t>(high - low + 1));
  };
  std::map<std::optional<Kind>, int> count;
  for (int trial = 0; trial < 10000; ++trial) {
    const int extent = std::vector<int>{1, 2, 5, 100}[random() % 4];
    Curve curve(static_cast<size_t>(draw(0, 10)));
    for (Vector3& point : curve)
      for (int i = 0; i < 3; ++i) point[i] = draw(-extent, extent);
    const int w = draw(-2, 2), x = draw(-2, 2), y = draw(-2, 2), z = draw(-2, 2);
    const Rotation turned = Rotation::FromQuaternion(w == 0 && x == 0 && y == 0 && z == 0 ? 1 : w, x, y, z);
    if (trial % 4 == 0 && extent > 2) {  // each second edge is seen through the middle
      for (size_t i = 1; i < curve.size(); i += 2)
        curve[i] =
            turned.Transpose() * Vector3{-(turned * curve[i - 1]).x, -(turned * curve[i - 1]).y, draw(-9, 9)};
    }
    const auto projection = ProjectCurve(curve, turned.rows[2]);  // what the turn makes the z axis
    const SlowProjection slow = ProjectSlowly(curve, turned);
    ++count[slow.fault];
    const auto* fault = std::get_if<CurveFault>(&projection);
    ASSERT_EQ(fault ? std::optional(fault->kind) : std::nullopt, slow.fault) << trial;
    if (fault) continue;
    ASSERT_EQ(std::get<CurveProjection>(projection).p, slow.p) << trial;
    ASSERT_TRUE(IsPlanar(slow.p));
  }
  EXPECT_EQ(count.size(), 9U);  // no fault and all kinds but too many intersections
  for (const auto& [kind, times] : count) EXPECT_GT(times, 20) << (kind ? static_cast<int>(*kind) : -1);
}

RC_GTEST_PROP(CurveProjection, ReversingTheRopeGivesTheEquivalentPData, ()) {
  Curve curve = FairCurve();
  const PData p = Seen(curve);
  std::reverse(curve.begin(), curve.end());
  RC_ASSERT(Seen(curve) == EquivalentPData(p));
}

RC_GTEST_PROP(CurveProjection, MirrorsOfTheCurveGiveTheMirrorImages, ()) {
  const Curve curve = FairCurve();
  Curve in_table = curve, on_table = curve;
  for (Vector3& point : in_table) point.z = -point.z;
  for (Vector3& point : on_table) point.x = -point.x;
  RC_ASSERT(Seen(in_table) == MirrorHeights(Seen(curve)));
  RC_ASSERT(Seen(on_table) == MirrorShape(Seen(curve)));
  // From below, over and under change places and left and right, too.
  RC_ASSERT(Seen(curve, {0, 0, -1}) == MirrorShape(MirrorHeights(Seen(curve))));
}

RC_GTEST_PROP(CurveProjection, TurningShiftingAndScalingTheRopeWithTheViewChangesNothing, ()) {
  const Curve curve = FairCurve();
  const Rotation turned = RandomRotation();
  const Rational scale(Uniform(1, 50), Uniform(1, 50));
  const Vector3 shift{Rational(Uniform(-9, 10), 7), 3, Rational(-1, 3)};
  Curve moved;
  for (const Vector3& point : curve) moved.push_back(scale * (turned * point) + shift);
  RC_ASSERT(Seen(moved, turned * kAbove) == Seen(curve));
}

RC_GTEST_PROP(CurveProjection, DividingAnEdgeChangesNothing, ()) {
  Curve curve = FairCurve();
  const PData p = Seen(curve);
  const auto i = Uniform<size_t>(1, curve.size());
  const Rational at(Uniform(1, 1000),
                    1009);  // no crossing's place: its denominator has no factor 1009
  const Vector3 between = curve[i - 1] + at * (curve[i] - curve[i - 1]);
  curve.insert(curve.begin() + static_cast<std::ptrdiff_t>(i), between);
  const auto divided = ProjectCurve(curve, kAbove);
  RC_PRE(std::holds_alternative<CurveProjection>(divided));
  RC_ASSERT(std::get<CurveProjection>(divided).p == p);
}

// A coil of 10,000 points: each turn crosses the ones before and after it. Integers beyond 64 bits, too.
TEST(CurveProjection, TenThousandPoints) {
  for (const int64_t size : {int64_t{1}, int64_t{1} << 40}) {
    Curve curve;
    for (int i = 0; i < 2500; ++i) {
      const Rational x(Integer(4 * i)), s{Integer(size)};
      for (const Vector3& corner : {Vector3{x, -7, 0}, {x + 5, -8, 1}, {x + 6, 8, 3}, {x - 1, 7, 2}})
        curve.push_back(s * corner);
    }
    const PData p = Seen(curve);
    EXPECT_TRUE(IsPlanar(p));
    EXPECT_GT(p.crossings(), 2500);
  }
}

}  // namespace
}  // namespace tact::knot

#include "algebra/knot/curve_views.h"

#include <gtest/gtest.h>

#include <climits>

namespace tact::knot {
namespace {

using algebra::Vector3;

// A vertical edge, and a loop that is flat from the side.
const Curve kStanding = {{0, 0, 0}, {0, 0, 10}, {6, 1, 10}, {6, 0, 4}, {-4, 1, 3}, {-4, 2, 20}};

int Crossings(const Curve& curve, const Vector3& view) {
  const auto projection = ProjectCurve(curve, view);
  if (std::holds_alternative<CurveFault>(projection)) return INT_MAX;
  return std::get<CurveProjection>(projection).p.crossings();
}

TEST(CurveViews, CandidatesAreDifferentLinesOfSightFromAbove) {
  const std::vector<Vector3> views = CandidateViews();
  EXPECT_EQ(views.size(), 37U);
  EXPECT_EQ(views.front(), ViewFromAbove());
  for (size_t i = 0; i < views.size(); ++i) {
    EXPECT_GT(views[i].z.sign(), 0);
    for (size_t j = 0; j < i; ++j) EXPECT_FALSE(Parallel(views[i], views[j]));
  }
  // Every direction has a candidate, or its opposite, within 32 degrees: cos^2 > 18/25.
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      for (int z = 0; z <= 5; ++z) {
        const Vector3 direction{x, y, z};
        if (direction.IsZero()) continue;
        bool near = false;
        for (const Vector3& view : views) {
          const algebra::Rational dot = Dot(view, direction);
          near |= 25 * dot * dot > 18 * Dot(view, view) * Dot(direction, direction);
        }
        EXPECT_TRUE(near) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(CurveViews, TheFirstWithTheFewestIntersectionsIsChosen) {
  ASSERT_EQ(Crossings(kStanding, ViewFromAbove()), INT_MAX);
  const auto chosen = std::get<ProjectedCurves>(ProjectCurvesFromBestView({kStanding}));
  EXPECT_EQ(chosen.views, 37);
  int fewest = INT_MAX;
  Vector3 first;
  for (const Vector3& view : CandidateViews()) {
    const int crossings = Crossings(kStanding, view);
    if (crossings < fewest) {
      fewest = crossings;
      first = view;
    }
  }
  EXPECT_EQ(chosen.view, first);
  EXPECT_EQ(chosen.projections.front().p, std::get<CurveProjection>(ProjectCurve(kStanding, first)).p);
}

TEST(CurveViews, SeveralCurvesAreSeenFromOneView) {
  const Curve lying = {{0, 0, 0}, {0, 10, 0}, {6, 10, 1}, {6, 4, 0}, {-4, 3, 1}, {-4, 20, 2}};
  const auto chosen = std::get<ProjectedCurves>(ProjectCurvesFromBestView({kStanding, lying}));
  ASSERT_EQ(chosen.projections.size(), 2U);
  const int total = chosen.projections[0].p.crossings() + chosen.projections[1].p.crossings();
  for (const Vector3& view : CandidateViews()) {
    const int a = Crossings(kStanding, view), b = Crossings(lying, view);
    if (a != INT_MAX && b != INT_MAX) {
      EXPECT_LE(total, a + b);
    }
  }
}

TEST(CurveViews, WhatNoViewMendsIsSaidOfItsCurve) {
  const auto faulty = std::get<FaultyCurve>(
      ProjectCurvesFromBestView({kStanding, {{0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {2, 1, 2}, {1, 0, 1}}}));
  EXPECT_EQ(faulty.index, 1U);
  EXPECT_EQ(faulty.fault.kind, CurveFaultKind::kMeetsItself);
}

}  // namespace
}  // namespace tact::knot

#include "robot/planning/optimal_trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/solid/convex_hull.h"
#include "robot/planning/angle_and_location.h"
#include "tests/robot/planning/peg_states.h"

namespace tact::planning {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180;

TEST(OptimalTrajectory, EveryTransitionOfThePegInsertionIsPlannedBothWays) {
  for (const char* file : {"demonstration.json", "turned.json"}) {
    DemonstrationStates states = PegStates(file);
    for (size_t i = 0; i + 1 < states.states.size(); ++i) {
      const PlannedTransition forth = PlanTransition(states, i, i + 1, 10),
                              back = PlanTransition(states, i + 1, i, 10);
      for (const PlannedTransition* planned : {&forth, &back}) {
        EXPECT_EQ(planned->failure(), "") << file << ", " << states.states[i].name;
        EXPECT_LT(planned->trajectory.violation, 1e-13);
        EXPECT_EQ(planned->check.overlap, 0);
      }
      EXPECT_NEAR(forth.trajectory.angle, back.trajectory.angle, 1e-12);
      EXPECT_NEAR(forth.trajectory.distance, back.trajectory.distance, 1e-12);
      EXPECT_NE(forth.trajectory.inverse, back.trajectory.inverse);
    }
  }
}

// By hand, from the poses in the file: B to C is a slide of 202/101 along x; E to F undoes the turn of 2 atan(1/10); F to G and G
// to H go down by 2 and 3.
TEST(OptimalTrajectory, AnglesAndDistancesAreThoseOfTheExample) {
  const DemonstrationStates states = PegStates("demonstration.json");
  const auto plan = [&](size_t i) { return PlanTransition(states, i, i + 1, 50).trajectory; };
  EXPECT_NEAR(plan(1).distance, 2, 1e-13);
  EXPECT_EQ(CaseText(plan(1)), "rotational 3 + translational 2");
  EXPECT_NEAR(plan(4).angle, 2 * std::atan(0.1), 1e-13);
  EXPECT_NEAR(plan(5).distance, 2, 1e-13);
  EXPECT_EQ(CaseText(plan(5)), "rotational 1 + translational 2, inverse");
  EXPECT_NEAR(plan(6).distance, 3, 1e-13);
}

// By hand: in turned.json B's quaternion is (10, 0, 0, 1)(10, 0, 1, 0), so the edge turns by 2 atan(1/10) about the vertical.
TEST(OptimalTrajectory, TheCuresOfA6AreApplied) {
  const DemonstrationStates states = PegStates("turned.json");
  const Trajectory first = PlanTransition(states, 0, 1, 20).trajectory,
                   second = PlanTransition(states, 1, 2, 20).trajectory;
  EXPECT_EQ(CaseText(first), "rotational 4, A.6.1 edge-face + translational 3");
  EXPECT_EQ(CaseText(second), "rotational 3, A.6.2 edge-face + translational 2");
  EXPECT_NEAR(second.angle, 2 * std::atan(0.1), 1e-13);
  // The least angle is the edge's off the plane: the third entry of its direction, of A's quaternion (10, 1, 3, 2).
  const Eigen::Matrix3d R = Eigen::Quaterniond(10, 1, 3, 2).normalized().toRotationMatrix();
  EXPECT_NEAR(first.turns.least_angle, std::asin(std::abs(R(2, 1))), 1e-13);
  EXPECT_GT(first.angle, first.turns.least_angle + 0.05 * kDegree);
  // Rotation comes before translation.
  EXPECT_TRUE(first.segments.front().is_turn());
  EXPECT_FALSE(first.segments.back().is_turn());
}

algebra::Polyhedron Box(const algebra::Vector3& low, const algebra::Vector3& high) {
  std::vector<algebra::Vector3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z});
  return algebra::BuildPolyhedron(algebra::ConvexHull(corners));
}

// Which vertices of the box are at the height zero.
Relation BottomOn(const SolidPair& pair, const Vector3d& normal) {
  Relation relation;
  size_t floor = 0;
  while (pair.fixed_f.faces[floor].normal.dot(normal) < 0.5) ++floor;
  for (size_t v = 0; v < pair.moving_f.vertices.size(); ++v) {
    if (pair.moving_f.vertices[v].z() == 0)
      relation.push_back({recognition::PointContactKind::kVertexFace, v, floor, 1});
  }
  return relation;
}

// A box above a floor, rolled by 20 degrees about x, comes to lie flat: case 2 with the turn about the vertical left out, case 3 down.
TEST(OptimalTrajectory, ABoxIsLaidDownByTheSmallestTurnAndTheShortestLine) {
  const SolidPair pair = MakeSolidPair(Box({-1, -1, 0}, {1, 1, 1}), Box({-9, -9, -1}, {9, 9, 0}));
  const double roll = 20 * kDegree, yaw = 50 * kDegree;
  ContactState start{{}, {joint::RotationExp({roll, 0, 0}), {0, 0, 5}}, {}};
  ContactState end{BottomOn(pair, {0, 0, 1}), {joint::RotationExp({0, 0, yaw}), {3, 4, 0}}, {}};
  const Trajectory t = PlanOptimalTrajectory(pair, start, end, 10);
  EXPECT_EQ(t.failure, "");
  EXPECT_EQ(CaseText(t), "rotational 2 + translational 3");
  EXPECT_NEAR(t.angle, roll, 1e-12);
  EXPECT_NEAR((t.samples.back().X_FM.p - Vector3d(0, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(t.distance, 5, 1e-12);
  // The inverse lifts first and turns then.
  const Trajectory back = PlanOptimalTrajectory(pair, end, start, 10);
  EXPECT_TRUE(back.inverse);
  EXPECT_FALSE(back.segments.front().is_turn());
  EXPECT_TRUE(back.segments.back().is_turn());
}

// Edge-face to a fixed orientation that takes the edge off the plane: (A.24) cannot make it.
TEST(OptimalTrajectory, AnEdgeThatLeavesItsPlaneIsAFailureThatIsNamed) {
  const SolidPair pair = MakeSolidPair(Box({-1, -1, 0}, {1, 1, 1}), Box({-9, -9, -1}, {9, 9, 0}));
  Relation edge, flat = BottomOn(pair, {0, 0, 1});
  for (const auto& contact : flat) {
    if (pair.moving_f.vertices[contact.moving].x() == -1) edge.push_back(contact);
  }
  ASSERT_EQ(edge.size(), 2U);
  const double tilt = 30 * kDegree;
  const joint::Transform tilted{joint::RotationExp({0, -tilt, 0}), {0, 0, std::sin(tilt)}};
  // Three dimensions restricted, as walls would do: said by the ranks.
  const Trajectory t = PlanOptimalTrajectory(pair, {edge, tilted, Ranks{1, 1}},
                                             {flat, {joint::RotationExp({0.1, 0, 0}), {}}, Ranks{1, 3}}, 10);
  EXPECT_NE(t.failure.find("(A.24) has no solution"), std::string::npos) << t.failure;
  EXPECT_NE(t.failure.find("edge-face"), std::string::npos) << t.failure;
}

TEST(TrajectoryCheck, OverlapOnTheWayIsFoundAndItsSampleNamed) {
  // Straight through a wall.
  const SolidPair pair = MakeSolidPair(Box({0, 0, 0}, {1, 1, 1}), Box({4, -5, -5}, {5, 5, 5}));
  Relation side;
  size_t wall = 0;
  while (pair.fixed_f.faces[wall].normal.x() < 0.5) ++wall;  // its far side, x = 5
  for (size_t v = 0; v < pair.moving_f.vertices.size(); ++v) {
    if (pair.moving_f.vertices[v].x() == 0)
      side.push_back({recognition::PointContactKind::kVertexFace, v, wall, 1});
  }
  const ContactState start{{}, {}, {}}, end{side, {Eigen::Matrix3d::Identity(), {5, 0, 0}}, {}};
  const Trajectory t = PlanOptimalTrajectory(pair, start, end, 10);
  EXPECT_EQ(t.failure, "");
  const TrajectoryCheck check = CheckTrajectory(pair, start, end, t);
  EXPECT_EQ(check.failure.find("the solids overlap by 0.5, sample 8 of 11"), 0U) << check.failure;
}

// Twin: the pseudo-inverse's shortest step, for rows of any rank.
TEST(AngleAndLocation, TheNearestLocationIsThatOfThePseudoInverse) {
  const DemonstrationStates states = PegStates("turned.json");
  for (const PlannedState& named : states.states) {
    const auto& [relation, X, ranks] = named.state;
    const Vector3d from = X.p + Vector3d(0.3, -0.2, 0.5);
    const Location found =
        NearestLocation(relation, states.solids.moving_f, states.solids.fixed_f, X.R, from);
    EXPECT_LT(found.violation, 1e-13) << named.name;
    Eigen::MatrixXd N(relation.size(), 3);
    Eigen::VectorXd gaps(relation.size());
    for (size_t i = 0; i < relation.size(); ++i) {
      const auto gap = GapOf(relation[i], states.solids.moving_f, states.solids.fixed_f, {X.R, from});
      N.row(static_cast<Eigen::Index>(i)) = gap.row.tail<3>();
      gaps[static_cast<Eigen::Index>(i)] = gap.gap;
    }
    // By gradient descent from zero, which stays in the rows' span: slow, but no decomposition.
    Vector3d step = Vector3d::Zero();
    for (int k = 0; k < 20000 && relation.size() > 0; ++k)
      step -= N.transpose() * (N * step + gaps) / static_cast<double>(2 * relation.size());
    EXPECT_LT((found.p - from - step).norm(), 1e-9) << named.name;
  }
}

}  // namespace
}  // namespace tact::planning

#include "robot/recognition/relation_candidates.h"

#include <gtest/gtest.h>

#include "robot/recognition/exact_pose.h"
#include "tests/robot/recognition/solids.h"

namespace tact::recognition {
namespace {

using algebra::Polyhedron;

struct CubeOnTable : testing::Test {
  Polyhedron cube = Box(1, 1, 1), table = Box(10, 10, 1);
  ProximitySolid moving{cube}, fixed{table};
  joint::Transform Above(double height, double tilt) const {
    return {joint::RotationExp({tilt, 0, 0}), {0, 0, 2 + height}};
  }
};

// By hand: only the four vertices below are near, each on the top face.
TEST_F(CubeOnTable, NearContactsAreTheLowerVertices) {
  const auto near = FindNearContacts(moving, fixed, Above(0.1, 0), {0.2, 0.1});
  ASSERT_EQ(near.size(), 4U);
  for (const NearContact& n : near) {
    EXPECT_EQ(n.contact.kind, PointContactKind::kVertexFace);
    EXPECT_EQ(n.aside, 0);
    EXPECT_EQ(table.faces[n.contact.fixed].normal, (algebra::Vector3{0, 0, 1}));
  }
  EXPECT_TRUE(FindNearContacts(moving, fixed, Above(0.3, 0), {0.2, 0.1}).empty());
}

// By hand: a face on a face takes three DOFs, and its pose lies at height 2, upright.
TEST_F(CubeOnTable, AFaceOnAFaceIsTheBestGuess) {
  const auto candidates = FindRelationCandidates(moving, fixed, Above(0.05, 0.03), {.noise = {0.03, 0.05}});
  ASSERT_FALSE(candidates.empty());
  const RelationCandidate& best = candidates.front();
  EXPECT_EQ(best.contacts.size(), 4U);
  EXPECT_EQ(best.taken, 3);
  EXPECT_NEAR(best.X_FM.p.z(), 2, 1e-9);
  EXPECT_NEAR(best.X_FM.R(2, 2), 1, 1e-12);
  // One standard deviation of tilt, one of height.
  EXPECT_NEAR(best.change.norm(), std::sqrt(2), 1e-2);
  EXPECT_NEAR(best.share.sum(), 3, 1e-9);
}

TEST_F(CubeOnTable, TiltedTooFarItStandsOnAnEdge) {
  const auto candidates = FindRelationCandidates(moving, fixed, Above(0.25, 0.25), {.noise = {0.01, 0.02}});
  ASSERT_FALSE(candidates.empty());
  EXPECT_EQ(candidates.front().taken, 2);
  EXPECT_EQ(candidates.front().contacts.size(), 2U);
}

TEST_F(CubeOnTable, FarAwayNothingTouches) {
  const auto candidates = FindRelationCandidates(moving, fixed, Above(3, 0), {.noise = {0.03, 0.05}});
  ASSERT_EQ(candidates.size(), 1U);
  EXPECT_TRUE(candidates.front().contacts.empty());
  EXPECT_EQ(candidates.front().cost, 0);
}

// Below the table's face by a little more than the noise: no contact is no candidate that penetrates.
TEST_F(CubeOnTable, APenetratingPoseIsLiftedOut) {
  for (const auto& candidate :
       FindRelationCandidates(moving, fixed, Above(-0.05, 0.01), {.noise = {0.03, 0.05}})) {
    if (candidate.contacts.empty()) continue;
    const ExactPose exact = FindExactPose(cube, table, candidate.contacts, candidate.X_FM);
    EXPECT_TRUE(exact.X_FM) << exact.why;
  }
}

}  // namespace
}  // namespace tact::recognition

// The methods on the relations of Table 2.1, against each other, Ipopt and what can be said by hand.
#include "robot/correction/correct.h"

#include <gtest/gtest.h>

#include "algebra/contact/motion_dof.h"
#include "robot/correction/gauss_newton.h"
#include "robot/correction/linear_correction.h"
#include "robot/correction/nearest_pose_ipopt.h"
#include "robot/correction/table_noise.h"

namespace tact::correction {
namespace {

using joint::Transform;

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

// Restricted DOFs as the printed means of the linear method have them (table_relations.h), from the exact engine.
TEST(TableRelations, RestrictedDofsGrow) {
  const std::vector<std::array<int, 2>> expected = {{1, 1}, {2, 2}, {2, 2}, {2, 3}, {2, 3}};
  for (size_t i = 0; i < expected.size(); ++i) {
    const TableCase c(TableRelationNames()[i]);
    const algebra::MotionDof dof = ComputeMotionDof(c.table.found.relation);
    EXPECT_EQ(dof.translation.restricted, expected[i][0]) << c.table.name;
    EXPECT_EQ(dof.rotation.restricted, expected[i][1]) << c.table.name;
    const Ranks ranks = RanksAt(c.models, c.relation.contacts, *c.relation.realisation);
    EXPECT_EQ(ranks.translation, expected[i][0]) << c.table.name;
    EXPECT_EQ(ranks.rotation, expected[i][1]) << c.table.name;
  }
}

TEST(Correct, ACorrectPoseStays) {
  for (const std::string& name : TableRelationNames()) {
    const TableCase c(name);
    for (const Method method :
         {Method::kGaussNewton, Method::kLinear, Method::kNearest, Method::kNearestRotationFirst}) {
      const Correction answer = Correct(method, c.models, c.relation, *c.relation.realisation);
      EXPECT_EQ(answer.outcome, Outcome::kCorrected) << name << ", " << ToString(method);
      EXPECT_LT(answer.rotation + answer.translation, 1e-6) << name << ", " << ToString(method);
    }
  }
}

// One plane: only height and tilt of the edge count. Raised by 3 mm, it comes down by 3 mm.
TEST(Correct, ALiftedEdgeComesDown) {
  const TableCase c("A");
  Transform X0 = *c.relation.realisation;
  X0.p.z() += 3;
  for (const Method method : {Method::kGaussNewton, Method::kLinear, Method::kNearestRotationFirst}) {
    const Correction answer = Correct(method, c.models, c.relation, X0);
    EXPECT_EQ(answer.outcome, Outcome::kCorrected);
    if (method == Method::kGaussNewton) continue;  // it turns, too
    EXPECT_NEAR(answer.translation, 3, 1e-4);
    EXPECT_LT(answer.rotation, 1e-5);
  }
}

// The least turn that lays a direction level is the angle between it and the plane; no turn of the relation does with
// less, so the linear method's is not smaller, and ours, rotation first, is that.
TEST(Correct, TheLeastTurnOfAnEdgeOntoAPlane) {
  const TableCase c("A");
  perception::RandomNumbers random(11);
  for (int i = 0; i < 50; ++i) {
    const Transform X0 = Noisy(*c.relation.realisation, random);
    const double least = std::abs(std::asin((X0.R * Eigen::Vector3d::UnitY()).z()));
    const Correction linear = Correct(Method::kLinear, c.models, c.relation, X0);
    EXPECT_GE(linear.rotation, least - 1e-9);
    const Correction ours = Correct(Method::kNearestRotationFirst, c.models, c.relation, X0);
    ASSERT_EQ(ours.outcome, Outcome::kCorrected);
    EXPECT_NEAR(ours.rotation, least, 1e-5);
  }
}

// With all of the rotation restricted the displacement is the noise.
TEST(Correct, InContactRelationCTheTurnIsTheNoise) {
  for (const std::string name : {"C", "C seated"}) {
    const TableCase c(name);
    perception::RandomNumbers random(12);
    for (int i = 0; i < 20; ++i) {
      const Transform X0 = Noisy(*c.relation.realisation, random);
      const double noise = DisplacementBetween(*c.relation.realisation, X0, kOrigin).rotation;
      EXPECT_NEAR(Correct(Method::kLinear, c.models, c.relation, X0).rotation, noise, 1e-9);
      const Correction ours = Correct(Method::kNearest, c.models, c.relation, X0);
      EXPECT_EQ(ours.outcome, Outcome::kCorrected);
      EXPECT_NEAR(ours.rotation, noise, 1e-6);
    }
  }
}

// Ours always answers, no farther than any other correct pose, and no farther than Ipopt from either of two starts.
void AgainstIpopt(const std::string& name, bool rotation_first, int trials, std::uint64_t seed) {
  const TableCase c(name);
  Metric metric;
  metric.rotation_first = rotation_first;
  const NearestPose nearest(c.models, c.relation, metric);
  const double length = metric.LengthFor(c.models);
  perception::RandomNumbers random(seed);
  int optimal = 0;
  for (int i = 0; i < trials; ++i) {
    const Transform X0 = Noisy(*c.relation.realisation, random);
    const NearestPoseAnswer ours = nearest.Find(X0);
    ASSERT_EQ(ours.outcome, Outcome::kCorrected) << name << ", trial " << i;
    EXPECT_LE(ours.distance,
              DisplacementBetween(X0, *c.relation.realisation, kOrigin).Distance(length) + 1e-9);
    for (const Transform& start : {X0, *c.relation.realisation}) {
      const IpoptAnswer ipopt = NearestPoseByIpopt(c.models, c.relation, X0, start, metric);
      if (!ipopt.optimal || ipopt.outcome != Outcome::kCorrected) continue;
      ++optimal;
      EXPECT_LE(ours.distance, 1.01 * ipopt.distance) << name << ", trial " << i;
    }
  }
  EXPECT_GT(optimal, trials / 2) << name;  // the comparison took place
}

TEST(NearestPose, NoFartherThanIpopts) {
  for (const std::string& name : TableRelationNames()) AgainstIpopt(name, false, 4, 21);
}
TEST(FullNearestPose, NoFartherThanIpopts) {
  for (const std::string& name : TableRelationNames()) {
    AgainstIpopt(name, false, 12, 22);
    AgainstIpopt(name, true, 6, 23);
  }
}

TEST(NearestPose, FindsARealisationWhereNoneIsGiven) {
  for (const std::string& name : TableRelationNames()) {
    TableCase c(name);
    perception::RandomNumbers random(31);
    const Transform X0 = Noisy(*c.relation.realisation, random);
    c.relation.realisation.reset();
    EXPECT_EQ(Correct(Method::kNearest, c.models, c.relation, X0).outcome, Outcome::kCorrected) << name;
    EXPECT_EQ(Correct(Method::kLinear, c.models, c.relation, X0).outcome, Outcome::kNoRealisation) << name;
  }
}

TEST(NearestPose, HoldsAtFourTimesTheNoise) {
  for (const std::string& name : TableRelationNames()) {
    const TableCase c(name);
    const NearestPose nearest(c.models, c.relation);
    perception::RandomNumbers random(41);
    for (int i = 0; i < 50; ++i)
      EXPECT_EQ(nearest.Find(Noisy(*c.relation.realisation, random, 4)).outcome, Outcome::kCorrected) << name;
  }
}

// A corner cannot lie on the block's top and the peg's top face on the slot's floor corner at once: named, not guessed.
TEST(Correct, WhatCannotBeIsNamed) {
  const TableCase c("C");
  Relation relation = c.relation;
  for (const auto& contact : RelationOf(TableRelationNamed("A")).contacts)
    relation.contacts.push_back(contact);
  const Transform X0 = *c.relation.realisation;
  EXPECT_EQ(Correct(Method::kGaussNewton, c.models, relation, X0).outcome, Outcome::kNotConverged);
  relation.realisation.reset();
  EXPECT_EQ(Correct(Method::kNearest, c.models, relation, X0).outcome, Outcome::kNoRealisation);
}

}  // namespace
}  // namespace tact::correction

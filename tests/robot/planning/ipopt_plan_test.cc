#include "robot/planning/ipopt_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/planning/knot_jet.h"
#include "tests/robot/planning/peg_states.h"

namespace tact::planning {
namespace {

using Numbers = Eigen::Matrix<double, 7, 1>;

Jet JetAt(const DemonstrationStates& states, const recognition::PointContact& contact, const Numbers& x) {
  return GapJet(contact, states.solids.moving_f, states.solids.fixed_f, states.solids.size,
                KnotJets(x.data()));
}

// The example has no vertex of the slot on a face of the peg: one that is apart is added. Differences of a polynomial: their error is the step squared.
TEST(KnotJet, DerivativesAreThoseOfDifferences) {
  const DemonstrationStates states = PegStates("turned.json");
  Numbers x;
  x << 0.8, 0.1, -0.3, 0.5, 0.4, -0.7, 0.2;
  const double h = 1e-4;
  std::array<int, 3> kinds{};
  const Relation apart = {{recognition::PointContactKind::kFaceVertex, 3, 2, 1}};
  std::vector<Relation> relations = {apart};
  for (const PlannedState& named : states.states) relations.push_back(named.state.relation);
  for (const Relation& relation : relations) {
    for (const auto& contact : relation) {
      ++kinds[static_cast<size_t>(contact.kind)];
      const Jet jet = JetAt(states, contact, x);
      for (int i = 0; i < 7; ++i) {
        Numbers step = Numbers::Zero();
        step[i] = h;
        const Jet up = JetAt(states, contact, x + step), down = JetAt(states, contact, x - step);
        EXPECT_NEAR(jet.gradient[i], (up.value - down.value) / (2 * h), 1e-7);
        EXPECT_LT((jet.hessian.col(i) - (up.gradient - down.gradient) / (2 * h)).norm(), 1e-6);
      }
    }
  }
  EXPECT_GT(kinds[0], 0);
  EXPECT_GT(kinds[1], 0);
  EXPECT_GT(kinds[2], 0);
}

// Another tool: the same costs where both are optimal, and less where (A.19) is not.
TEST(IpoptPlan, AgreesWithTheClosedFormOnThePegInsertion) {
  const DemonstrationStates states = PegStates("turned.json");
  for (size_t i = 0; i + 1 < states.states.size(); ++i) {
    const ContactState &start = states.states[i].state, &end = states.states[i + 1].state;
    const Trajectory closed = PlanOptimalTrajectory(states.solids, start, end, 200);
    const IpoptPlan thesis = PlanByIpopt(states.solids, start, end, closed, PathDefinition::kThesis),
                    least = PlanByIpopt(states.solids, start, end, closed, PathDefinition::kLeast);
    for (const IpoptPlan* plan : {&thesis, &least}) {
      EXPECT_TRUE(plan->solved) << i << ": " << plan->status;
      EXPECT_LT(plan->violation, 1e-9);
      EXPECT_LT(plan->stationarity, 1e-8);
      EXPECT_EQ(plan->overlap, 0);
    }
    EXPECT_NEAR(thesis.angle, closed.angle, 1e-6 * closed.angle + 1e-8) << i;
    EXPECT_NEAR(least.angle, i == 0 ? closed.turns.least_angle : closed.angle, 1e-6 * closed.angle + 1e-8)
        << i;
    EXPECT_LT(thesis.distance, closed.distance * (1 + 1e-6)) << i;
  }
}

}  // namespace
}  // namespace tact::planning

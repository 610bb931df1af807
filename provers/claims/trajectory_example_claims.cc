#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

#include "provers/claims/peg_in_hole_example.h"
#include "provers/claims/trajectory_claims.h"
#include "provers/report/trajectory_drawing.h"
#include "robot/cad/mesh.h"
#include "robot/planning/demonstration_plan.h"
#include "robot/planning/ipopt_plan.h"

namespace tact::provers {
namespace {

using planning::DemonstrationStates;
using planning::IpoptPlan;
using planning::PathDefinition;
using planning::PlannedTransition;

constexpr double kDegree = 180 / std::numbers::pi;
constexpr int kSteps = 50;           // samples a segment
constexpr double kEqualCost = 1e-6;  // relative: what Ipopt's tolerance and 20 knots leave of equal costs
constexpr double kNoCost = 1e-7;     // radian, millimetre: what Ipopt leaves of a motion that is none

DemonstrationStates Load(std::string_view text, const std::string& name) {
  std::istringstream in{std::string(text)};
  const auto demonstration = std::get<input::PoseDemonstration>(input::ReadDemonstration(in, name));
  recognition::ModelPair models;
  const cad::LengthUnit unit = models.unit = demonstration.models.unit;
  models.moving = ReadMesh(kPegOff, cad::MeshFormat::kOff, "peg.off", unit, unit).solid;
  models.fixed = ReadMesh(kSlotOff, cad::MeshFormat::kOff, "slot.off", unit, unit).solid;
  return planning::StatesOf(models, demonstration.states);
}

std::string Number(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

bool EqualCost(double closed, double ipopt) {
  return std::abs(closed - ipopt) <= std::max(kNoCost, kEqualCost * std::max(closed, ipopt));
}

struct Tally {
  long long planned = 0, solved = 0, thesis_equal = 0, least_equal = 0, ipopt_cheaper = 0, closed_cheaper = 0;
};

void Compare(const PlannedTransition& planned, const IpoptPlan& ipopt, bool thesis, Tally& tally) {
  if (!ipopt.solved || !planned.failure().empty()) return;
  const planning::Trajectory& t = planned.trajectory;
  ++tally.solved;
  const bool equal_angle = EqualCost(t.angle, ipopt.angle);
  (thesis ? tally.thesis_equal : tally.least_equal) += equal_angle ? 1 : 0;
  if (!equal_angle) ++(ipopt.angle < t.angle ? tally.ipopt_cheaper : tally.closed_cheaper);
}

Outcome PlanAll(const DemonstrationStates& states) {
  Outcome outcome;
  Table table{"Closed form and Ipopt (20 knots), degrees and millimetres",
              {"Transition", "Case", "Angle", "Distance", "Violation", "Angle, Ipopt", "Distance, Ipopt",
               "Angle, by (A.19)", "Distance, by (A.10)", "Failure"},
              {}};
  Tally tally;
  const size_t count = states.states.size() - 1;
  for (size_t i = 0; i < count; ++i) {
    const PlannedTransition planned = planning::PlanTransition(states, i, i + 1, kSteps);
    const planning::Trajectory& t = planned.trajectory;
    std::vector<std::string> row = {states.states[i].name + " to " + states.states[i + 1].name, CaseText(t),
                                    Number("%.5f", t.angle * kDegree), Number("%.6f", t.distance),
                                    Number("%.1e", t.violation)};
    for (const auto definition : {PathDefinition::kLeast, PathDefinition::kThesis}) {
      const IpoptPlan ipopt = planning::PlanByIpopt(states.solids, states.states[i].state,
                                                    states.states[i + 1].state, t, definition);
      Compare(planned, ipopt, definition == PathDefinition::kThesis, tally);
      row.push_back(ipopt.solved ? Number("%.5f", ipopt.angle * kDegree) : ipopt.status);
      row.push_back(ipopt.solved ? Number("%.6f", ipopt.distance) : "-");
    }
    row.push_back(planned.failure().empty() ? "none" : planned.failure());
    tally.planned += planned.failure().empty() ? 1 : 0;
    table.rows.push_back(row);
    if (i < 2 || t.angle > 0)
      outcome.figures.push_back({row[0] + ": " + CaseText(t), DrawTrajectory(states.solids, t.samples)});
  }
  outcome.tables = {table};
  outcome.numbers = {{"transitions", static_cast<long long>(count)},
                     {"planned in closed form, without overlap", tally.planned},
                     {"Ipopt solved, of two programmes each", tally.solved},
                     {"equal angle, least of all", tally.least_equal},
                     {"equal angle, by (A.10), (A.19)", tally.thesis_equal},
                     {"Ipopt turns less", tally.ipopt_cheaper},
                     {"Ipopt turns more", tally.closed_cheaper}};
  outcome.verdict =
      tally.planned == static_cast<long long>(count) ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound = "our peg and slot, " + std::to_string(kSteps) + " samples a segment";
  return outcome;
}

Claim Aligned() {
  return {"thesis.A.5.peg-insertion",
          "Optimal trajectories of the seven transitions of the peg insertion can be calculated by linear "
          "solutions alone.",
          "A.5", "simulation", [](Effort) {
            Outcome outcome = PlanAll(Load(kPegDemonstration, "examples/peg_in_hole/demonstration.json"));
            outcome.evidence =
                "The depth directions of peg and slot are aligned at the start, as in the thesis. Every "
                "sample keeps the contact relation to rounding, "
                "and exact geometry finds no overlap. Ipopt minimizes first rotation, then translation, over "
                "knots that keep the "
                "contacts.";
            return outcome;
          }};
}

Claim TurnedAside() {
  return {
      "thesis.A.6.3.turned",
      "With the cures of A.6 the trajectories can be calculated where the depth directions are not aligned.",
      "A.6.3", "simulation", [](Effort) {
        Outcome outcome = PlanAll(Load(kPegTurned, "examples/peg_in_hole/turned.json"));
        outcome.evidence =
            "The first two transitions need A.6.1 (from free space to one edge on a face) and A.6.2 (from "
            "there to the rim). In the first "
            "Ipopt turns less than (A.19) has it, as thesis.A.6.1.least-turn explains; with (A.19) as a "
            "constraint both agree.";
        return outcome;
      }};
}

}  // namespace

std::vector<Claim> TrajectoryExampleClaims() { return {Aligned(), TurnedAside()}; }

}  // namespace tact::provers

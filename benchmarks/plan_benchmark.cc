/// @file
/// Trajectories of the peg insertion: the closed form's time for 100 samples, Ipopt's, and what both cost.
/// Model   Each transition of examples/peg_in_hole, aligned and turned. Times are the least of repeated runs: what the
///         work takes where nothing disturbs it. Costs are angles; of the thesis' definition where (A.19) is not the least.
/// Exit    0; 1 if a trajectory fails, costs differ by more than 1e-6 or a time asked for is missed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "robot/planning/demonstration_plan.h"
#include "robot/planning/ipopt_plan.h"

namespace tact::planning {
namespace {

constexpr double kMostMicroseconds = 50;
constexpr double kLeastRatio = 1000;
constexpr double kEqualCost = 1e-6;  // relative
constexpr double kNoCost = 1e-8;     // radian

template <typename Run>
double LeastSeconds(int runs, const Run& run) {
  double least = HUGE_VAL;
  for (int i = 0; i < runs; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    run();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return least;
}

DemonstrationStates StatesIn(const std::string& file) {
  const std::string path = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/" + file;
  std::ifstream in(path);
  return StatesOf(input::ReadDemonstration(in, path), path);
}

bool Time(const DemonstrationStates& states, size_t i) {
  const ContactState &start = states.states[i].state, &end = states.states[i + 1].state;
  const Trajectory one = PlanOptimalTrajectory(states.solids, start, end, 99);
  const int steps = 99 / static_cast<int>(std::max<size_t>(1, one.segments.size()));
  IpoptPlan ipopt;
  const double closed = LeastSeconds(2000, [&] { PlanOptimalTrajectory(states.solids, start, end, steps); });
  const double programme =
      LeastSeconds(3, [&] { ipopt = PlanByIpopt(states.solids, start, end, one, PathDefinition::kThesis); });
  const bool equal = std::abs(ipopt.angle - one.angle) <= kEqualCost * one.angle + kNoCost;
  const bool good = one.failure.empty() && ipopt.solved && equal && 1e6 * closed <= kMostMicroseconds &&
                    programme >= kLeastRatio * closed;
  std::printf("  %s -> %s  %6.1f us  Ipopt %7.1f ms  %6.0f times  angle %.9f and %.9f%s\n",
              states.states[i].name.c_str(), states.states[i + 1].name.c_str(), 1e6 * closed, 1e3 * programme,
              programme / closed, one.angle, ipopt.angle, good ? "" : "  MISSED");
  return good;
}

}  // namespace
}  // namespace tact::planning

int main() {
  bool good = true;
  for (const char* file : {"demonstration.json", "turned.json"}) {
    std::printf("%s: 100 samples, at most 50 us; Ipopt at least 1000 times as long\n", file);
    const auto states = tact::planning::StatesIn(file);
    for (size_t i = 0; i + 1 < states.states.size(); ++i) good &= tact::planning::Time(states, i);
  }
  return good ? 0 : 1;
}

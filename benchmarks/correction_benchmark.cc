/// @file
/// Poses corrected: ours against Ipopt, answers checked.
/// Model   The relations of Table 2.1, the thesis' noise. A ratio is of distances (nearest_pose.h), ours over the best that
///         Ipopt finds from the pose seen and from the realisation, over the poses where it finds one; times are medians
///         and the longest, ours prepared once a relation, Ipopt from one start.
/// Exit    0; 1 if a pose is not corrected, a ratio exceeds 1.01 or a median time 2 ms.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "robot/correction/nearest_pose_ipopt.h"
#include "robot/correction/table_noise.h"

namespace tact::correction {
namespace {

constexpr double kMostRatio = 1.01, kMostSeconds = 2e-3;

template <class Work>
double Seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool Run(const std::string& name, bool rotation_first, int trials) {
  const TableCase c(name);
  Metric metric;
  metric.rotation_first = rotation_first;
  const NearestPose nearest(c.models, c.relation, metric);
  perception::RandomNumbers random(1);
  std::vector<double> ours, theirs;
  int corrected = 0, compared = 0, far = 0, nearer = 0;
  double worst = 0;
  for (int i = 0; i < trials; ++i) {
    const joint::Transform X0 = Noisy(*c.relation.realisation, random);
    NearestPoseAnswer answer;
    ours.push_back(Seconds([&] { answer = nearest.Find(X0); }));
    corrected += answer.outcome == Outcome::kCorrected;
    double best = HUGE_VAL;
    for (const joint::Transform& start : {X0, *c.relation.realisation}) {
      IpoptAnswer ipopt;
      theirs.push_back(Seconds([&] { ipopt = NearestPoseByIpopt(c.models, c.relation, X0, start, metric); }));
      if (ipopt.optimal && ipopt.outcome == Outcome::kCorrected) best = std::min(best, ipopt.distance);
    }
    if (best == HUGE_VAL) continue;
    ++compared;
    const double ratio = answer.distance / best;
    worst = std::max(worst, ratio);
    far += ratio > kMostRatio;
    nearer += ratio < 1 / kMostRatio;
  }
  const double median = Median(ours);
  const bool good = corrected == trials && far == 0 && median < kMostSeconds;
  std::printf("%-9s %-8s %6d %9d %8d %12.6f %7d %7d %9.3f %9.3f %9.3f %s\n", name.c_str(),
              rotation_first ? "rotation" : "both", trials, corrected, compared, worst, far, nearer,
              1e3 * median, 1e3 * *std::max_element(ours.begin(), ours.end()), 1e3 * Median(theirs),
              good ? "" : "MISSED");
  return good;
}

}  // namespace
}  // namespace tact::correction

int main(int count, char** arguments) {
  const int trials = count > 1 ? std::atoi(arguments[1]) : 1000;
  std::printf(
      "relation  first    trials corrected compared  worst ratio farther  nearer ours ms   longest  Ipopt "
      "ms\n");
  bool good = true;
  for (const std::string& name : tact::correction::TableRelationNames())
    for (const bool rotation_first : {false, true})
      good &= tact::correction::Run(name, rotation_first, trials);
  return good ? 0 : 1;
}

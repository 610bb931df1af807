#include "robot/joint/conjugate_gradient.h"

#include <algorithm>
#include <cmath>

namespace tact::joint {
namespace {

constexpr int kMostDoublings = 40;
constexpr int kMostSecants = 60;
constexpr double kSlopeLeft = 1e-4;  // share of the first slope at which a line's minimum is good enough
constexpr double kTiny = 1e-300;     // against 0 / 0

struct Place {
  Unknowns x, gradient;
  double value = 0;
};

// Along a line: the slope and all the rest at a step.
struct Probe {
  double step = 0, slope = 0;
  Place place;
};

Probe ProbeAt(const Objective& objective, const Place& from, const Unknowns& direction, double step) {
  Probe probe{step, 0, {from.x + step * direction, Unknowns(from.x.size()), 0}};
  probe.place.value = objective(probe.place.x, &probe.place.gradient);
  probe.slope = probe.place.gradient.dot(direction);
  return probe;
}

// A place where the slope along the line is nearly zero and the value no larger than at `from`, if one is found.
Place LineMinimum(const Objective& objective, const Place& from, const Unknowns& direction, double first) {
  Probe low{0, from.gradient.dot(direction), from};
  const double enough = kSlopeLeft * std::abs(low.slope);
  Probe high = ProbeAt(objective, from, direction, first);
  for (int i = 0; i < kMostDoublings && high.slope < 0 && high.place.value <= low.place.value; ++i) {
    low = high;
    high = ProbeAt(objective, from, direction, 2 * low.step);
  }
  // Between them the value turns upward: a step that falls on moves low, any other moves high.
  for (int i = 0; i < kMostSecants && std::abs(low.slope) > enough; ++i) {
    double share = high.slope > 0 ? low.slope / (low.slope - high.slope) : 0.5;
    if (i % 3 == 2) share = 0.5;
    const Probe probe = ProbeAt(objective, from, direction, low.step + share * (high.step - low.step));
    if (probe.place.value <= low.place.value && std::abs(probe.slope) <= enough) return probe.place;
    (probe.slope < 0 && probe.place.value <= low.place.value ? low : high) = probe;
  }
  return low.place;
}

double Factor(CgUpdate update, const Unknowns& before, const Unknowns& after) {
  const double squares = std::max(before.squaredNorm(), kTiny);
  return update == CgUpdate::kFletcherReeves ? after.squaredNorm() / squares
                                             : std::max(0.0, after.dot(after - before) / squares);
}

}  // namespace

CgMinimum MinimizeByConjugateGradient(const Objective& objective, Unknowns start, const CgOptions& options) {
  Place at{start, Unknowns(start.size()), 0};
  at.value = objective(at.x, &at.gradient);
  Unknowns direction = -at.gradient;
  bool steepest = true;
  for (int k = 1; k <= options.most_iterations; ++k) {
    const double length = direction.norm();
    if (length < kTiny) return {at.x, at.value, k - 1, true};
    const double first = options.first_step > 0 ? options.first_step / length : 1;
    const Place next = LineMinimum(objective, at, direction, first);
    const double decrease = at.value - next.value;
    const double factor = Factor(options.update, at.gradient, next.gradient);
    at = next;
    if (decrease <= options.tolerance * std::abs(at.value) + kTiny) {
      if (steepest) return {at.x, at.value, k, true};
      direction = -at.gradient;
      steepest = true;
      continue;
    }
    direction = -at.gradient + factor * direction;
    steepest = k % start.size() == 0 || direction.dot(at.gradient) >= 0;
    if (steepest) direction = -at.gradient;
  }
  return {at.x, at.value, options.most_iterations, false};
}

}  // namespace tact::joint

#include "robot/recognition/knot_recognition.h"

#include <algorithm>
#include <array>

namespace tact::recognition {
namespace {

using knot::PData;

// Unexplained transitions first, then replaced P-data.
struct Cost {
  int unexplained = 0, swapped = 0;
  friend auto operator<=>(const Cost&, const Cost&) = default;
};

// The cheapest way to each reading (0 as given, 1 swapped) of a P-data, and the reading before it.
struct Step {
  std::array<Cost, 2> cost;
  std::array<size_t, 2> before{};
};

}  // namespace

KnotRecognition RecognizeKnot(const std::vector<PData>& sequence) {
  KnotRecognition result;
  if (sequence.empty()) return result;
  std::vector<std::array<PData, 2>> read;
  for (const PData& p : sequence) read.push_back({p, EquivalentPData(p)});

  // No way leads to the first one swapped: its end is the selective end.
  constexpr int kNever = 1 << 29;
  std::vector<Step> steps = {{{Cost{0, 0}, Cost{kNever, 0}}}};
  for (size_t t = 1; t < read.size(); ++t) {
    Step step;
    for (size_t now = 0; now < 2; ++now) {
      std::array<Cost, 2> by;
      for (size_t before = 0; before < 2; ++before) {
        by[before] = steps.back().cost[before];
        if (DetectMoves(read[t - 1][before], read[t][now]).empty()) ++by[before].unexplained;
        by[before].swapped += static_cast<int>(now);
      }
      step.before[now] = by[1] < by[0] ? 1 : 0;
      step.cost[now] = by[step.before[now]];
    }
    steps.push_back(step);
  }

  std::vector<size_t> chosen(read.size());
  chosen.back() = steps.back().cost[1] < steps.back().cost[0] ? 1 : 0;
  for (size_t t = read.size() - 1; t > 0; --t) chosen[t - 1] = steps[t].before[chosen[t]];
  for (size_t t = 0; t < read.size(); ++t) {
    const bool either = read[t][0] == read[t][1];
    result.ends.push_back(either ? EndRead::kEither : chosen[t] == 1 ? EndRead::kSwapped : EndRead::kAsGiven);
    if (t > 0) result.transitions.push_back(DetectMoves(read[t - 1][chosen[t - 1]], read[t][chosen[t]]));
  }
  return result;
}

}  // namespace tact::recognition

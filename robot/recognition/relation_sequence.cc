#include "robot/recognition/relation_sequence.h"

#include <algorithm>

namespace tact::recognition {

RelationSequence FindRelationSequence(const std::vector<std::vector<double>>& costs, const StepCost& step) {
  if (costs.empty()) return {};
  std::vector<std::vector<size_t>> before(costs.size());
  std::vector<double> least = costs[0];  // of a sequence that ends in each candidate
  for (size_t k = 1; k < costs.size(); ++k) {
    std::vector<double> next(costs[k].size());
    before[k].resize(costs[k].size());
    for (size_t to = 0; to < next.size(); ++to) {
      for (size_t from = 0; from < least.size(); ++from) {
        const double cost = least[from] + step(k, from, to);
        if (from > 0 && cost >= next[to]) continue;
        next[to] = cost;
        before[k][to] = from;
      }
      next[to] += costs[k][to];
    }
    least = std::move(next);
  }
  RelationSequence answer;
  const auto last = std::min_element(least.begin(), least.end());
  answer.cost = *last;
  answer.chosen = {static_cast<size_t>(last - least.begin())};
  for (size_t k = costs.size() - 1; k > 0; --k) answer.chosen.push_back(before[k][answer.chosen.back()]);
  std::reverse(answer.chosen.begin(), answer.chosen.end());
  return answer;
}

}  // namespace tact::recognition

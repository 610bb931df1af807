/// @file
/// The most plausible sequence of contact relations over a recording: one candidate a scene, the sum of the candidates' and
/// the steps' costs least.
/// Model   Costs are negative log-likelihoods. Dynamic programming over the scenes [Viterbi 1967]; of equally good sequences
///         the one with the earlier candidates in the later scenes.
/// Cost    O(scenes candidates^2) step costs.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tact::recognition {

/// The cost of candidate `to` in scene `scene` after candidate `from` in the scene before.
using StepCost = std::function<double(size_t scene, size_t from, size_t to)>;

struct RelationSequence {
  std::vector<size_t> chosen;  // of each scene's candidates
  double cost = 0;
};

/// costs[k][i] is that of candidate i of scene k. Precondition: every scene has a candidate.
RelationSequence FindRelationSequence(const std::vector<std::vector<double>>& costs, const StepCost& step);

}  // namespace tact::recognition

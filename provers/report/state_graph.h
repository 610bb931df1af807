/// @file
/// Contact relations as states, and what may lead from one to another [thesis, Fig. 2.22].
/// Model   States stand in a row. What was seen is an arrow above; what might be, in either direction, a line below, dotted
///         and crossed out where it is rejected.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tact::provers {

enum class StateLink { kSeen, kValid, kRejected };

struct StateEdge {
  size_t from = 0, to = 0;
  StateLink link = StateLink::kValid;
};

/// One <svg> element without caption, for Figure. `states` are their names, two lines each at most, divided by '\n'.
/// PreconditionError: an edge that ends nowhere, or where it begins.
std::string DrawStateGraph(const std::vector<std::string>& states, const std::vector<StateEdge>& edges);

}  // namespace tact::provers

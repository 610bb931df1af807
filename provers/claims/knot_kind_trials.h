/// @file
/// Trials of the claims on the four kinds of move, and what the trials on tying share.
#pragma once

#include <string>

#include "enumerators/move_graph.h"
#include "provers/ledger.h"

namespace tact::provers {

inline constexpr knot::MoveRules kCrossOnly = {false, false, false, true};
inline constexpr knot::MoveRules kNoCross = {true, true, true, false};

inline int GraphBound(Effort effort) {
  return effort == Effort::kQuick      ? 3
         : effort == Effort::kStandard ? 5
                                       : enumerators::MoveGraph::kMostCrossings;
}
inline std::string UpTo(int crossings) {
  return "all P-data with at most " + std::to_string(crossings) + " intersections";
}

Outcome TryKindsNeeded(Effort effort);
Outcome TryR3Redundant(Effort effort);
Outcome TryUntying(Effort effort);

}  // namespace tact::provers

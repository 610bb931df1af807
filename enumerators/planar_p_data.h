/// @file
/// All P-data of a sphere with so many intersections, each once, in an order that does not vary.
/// Model   Each code of code_tree.h in canonical order, with each choice of over and under: c bits counted upward, the last
///         intersection met first the fastest, 0 for over at the first meeting.
/// Cost    O(n) a P-data; nothing is stored.
#pragma once

#include "algebra/knot/p_data.h"
#include "enumerators/code_tree.h"

namespace tact::enumerators {

/// The code's P-data with these heights: bit k from above belongs to the k-th intersection met.
knot::PData WithHeights(const Code& code, uint32_t heights);

/// Visits each planar P-data with exactly that many intersections once, in an order that does not vary.
template <typename Visit>
void ForEachPlanarPData(int crossings, const Visit& visit) {
  ForEachCode(crossings, [&](const Code& code) {
    for (uint32_t heights = 0; heights < uint32_t{1} << crossings; ++heights)
      visit(WithHeights(code, heights));
  });
}
/// With up to that many.
template <typename Visit>
void ForEachPlanarPDataTo(int crossings, const Visit& visit) {
  for (int n = 0; n <= crossings; ++n) ForEachPlanarPData(n, visit);
}

}  // namespace tact::enumerators

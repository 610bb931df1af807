/// @file
/// Pairs of axis-parallel boxes that may overlap, by a sweep along one axis.
/// Model   an exact overlap is always reported, a report decides nothing (bounding_box.h).
/// Cost    O(n log n + pairs that overlap along the longest axis).
#pragma once

#include <functional>
#include <vector>

#include "algebra/solid/bounding_box.h"

namespace tact::algebra {

/// Calls visit(i, j) once for each pair with lefts[i] overlapping rights[j], in an order that depends on the
/// boxes only, until visit returns false.
void SweepOverlaps(const std::vector<BoundingBox>& lefts, const std::vector<BoundingBox>& rights,
                   const std::function<bool(size_t, size_t)>& visit);

}  // namespace tact::algebra

/// @file
/// Pairs of axis-parallel boxes that may overlap, by a sweep along one axis.
/// Model   boxes in doubles, rounded outwards: an exact overlap is always reported, a report decides nothing.
/// Cost    O(n log n + pairs that overlap along the longest axis).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "algebra/screw/vector3.h"

namespace tact::algebra {

struct Box {
  std::array<double, 3> low, high;

  /// Holds nothing.
  Box();
  void Add(const Vector3& point);
  void Add(const Box& other);
  bool Overlaps(const Box& other) const;
};

/// Calls visit(i, j) once for each pair with lefts[i] overlapping rights[j], in an order that depends on the
/// boxes only, until visit returns false.
void SweepOverlaps(const std::vector<Box>& lefts, const std::vector<Box>& rights,
                   const std::function<bool(size_t, size_t)>& visit);

}  // namespace tact::algebra

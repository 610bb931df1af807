/// @file
/// Random contact relations for comparisons with outside tools, degenerate on purpose.
/// Model   A relation draws a rule for its points (free, a few, on a line, in a plane, on lines of action
///         through a centre, on the faces of a box) and one for its normals (free, a few, a few and their
///         opposites, in a plane, axes, through an axis, what the box has); every fourth relation draws them
///         for each contact anew, so that all kinds meet. One relation in ten has singular contacts.
/// Exact   numerators and denominators of one digit; at most 12 contacts.
/// Cost    the relation of a number is made without those before it: shards need no common state.
#pragma once

#include <cstdint>

#include "algebra/contact/contact_relation.h"

namespace tact::oracle {

/// A small generator with the same sequence on every platform.
class Random {
 public:
  Random(uint64_t seed, uint64_t stream)
      : state_(seed * 0x9E3779B97F4A7C15u ^ (stream + 1) * 0xD1B54A32D192ED03u) {}
  uint64_t Next();
  /// From low to high, both included.
  int Int(int low, int high) {
    return low + static_cast<int>(Next() % static_cast<uint64_t>(high - low + 1));
  }
  bool OneIn(int n) { return Int(1, n) == 1; }

 private:
  uint64_t state_;
};

/// Relation number `index` of the stream that `seed` names.
algebra::ContactRelation RandomRelation(uint64_t seed, uint64_t index);

}  // namespace tact::oracle

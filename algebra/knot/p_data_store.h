/// @file
/// Many P-data, each kept once in few bytes and found again by value.
/// Cost    about a byte a column (three beyond 63 columns) and 16 bytes more; Insert O(n).
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

class PDataStore {
 public:
  static constexpr uint32_t kNone = UINT32_MAX;

  /// The number of p, from 0 in the order of insertion, and whether it is new.
  std::pair<uint32_t, bool> Insert(const PData& p);
  /// kNone if it is not there.
  uint32_t Find(const PData& p) const;
  PData Get(uint32_t number) const;

  size_t size() const { return starts_.size(); }
  size_t bytes() const { return bytes_.size() + 8 * starts_.size() + 4 * table_.size(); }

 private:
  void Encode(const PData& p) const;
  // The place in the table of what is encoded, or the free place for it.
  size_t Place() const;
  size_t LengthOf(uint32_t number) const;
  void Grow();

  std::vector<uint8_t> bytes_;
  std::vector<uint64_t> starts_;
  std::vector<uint32_t> table_;           // open addressing, a power of two long
  mutable std::vector<uint8_t> encoded_;  // scratch
};

}  // namespace tact::knot

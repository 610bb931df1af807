/// @file
/// Sets of row numbers below a fixed bound, as bits.
/// Errors  none: a row number must be below the bound, sets that meet must have the same bound.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tact::algebra {

class RowSet {
 public:
  RowSet() = default;
  /// Empty.
  explicit RowSet(size_t bound) : bound_(bound), words_((bound + 63) / 64) {}
  static RowSet All(size_t bound) {
    RowSet result(bound);
    for (size_t row = 0; row < bound; ++row) result.Insert(row);
    return result;
  }

  size_t bound() const noexcept { return bound_; }
  void Insert(size_t row) { words_[row / 64] |= uint64_t{1} << (row % 64); }
  void Erase(size_t row) { words_[row / 64] &= ~(uint64_t{1} << (row % 64)); }
  bool Contains(size_t row) const { return (words_[row / 64] >> (row % 64) & 1) != 0; }
  size_t size() const {
    size_t count = 0;
    for (const uint64_t word : words_) count += static_cast<size_t>(std::popcount(word));
    return count;
  }
  bool Meets(const RowSet& other) const {
    for (size_t i = 0; i < words_.size(); ++i) {
      if ((words_[i] & other.words_[i]) != 0) return true;
    }
    return false;
  }
  RowSet& operator&=(const RowSet& other) {
    for (size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  /// Increasing.
  std::vector<size_t> ToVector() const {
    std::vector<size_t> rows;
    for (size_t row = 0; row < bound_; ++row) {
      if (Contains(row)) rows.push_back(row);
    }
    return rows;
  }
  friend bool operator==(const RowSet& a, const RowSet& b) = default;

 private:
  size_t bound_ = 0;
  std::vector<uint64_t> words_;
};

}  // namespace tact::algebra

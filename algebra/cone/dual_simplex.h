/// @file
/// Which rows of a cone { x | A x >= 0 } vanish on all of it: an exact dual simplex method, n <= 6.
/// Model   Keep r = rank A independent rows B and M = det(B) B^-1, whose columns are the rays of the
///         simplicial cone { B x >= 0 }; their sum x has B x = det(B) > 0. A row a with a x <= 0 enters the
///         basis by the dual simplex rule for min g x, A x >= 1 (g the sum of the first basis, so that it
///         starts dual feasible; Bland's rule after kPatience pivots, hence finite). If a = sum_j c_j b_j /
///         det(B) has no positive c_j, then a and every b_j with c_j < 0 vanish on the cone; their slots are
///         dropped and the search goes on in the subspace that is left.
/// Exact   fraction-free [Bareiss 1968]: M stays integer, divisions leave no remainder. For T = int64_t every
///         product is formed in 128 bits and a result that does not fit ends the run with kOverflow.
/// Cost    O(m n) a pivot to find the entering row, O(n^2) to change the basis; no allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "algebra/error.h"
#include "algebra/exact/integer.h"

namespace tact::algebra {

__extension__ typedef __int128 Int128;

/// What the method needs of its numbers. Wide holds a sum of products without overflow.
template <typename T>
struct SimplexNumber;

template <>
struct SimplexNumber<int64_t> {
  using Wide = Int128;
  // Six entries below this add up in 64 bits, six products of an entry and such a sum in 128.
  static constexpr int64_t kLargest = int64_t{1} << 60;
  static Wide Multiply(int64_t a, int64_t b) { return static_cast<Wide>(a) * b; }
  static bool Narrow(Wide a, int64_t& out) {
    out = static_cast<int64_t>(a);
    return a < kLargest && a > -kLargest;
  }
  static Wide Divide(Wide a, int64_t d) {
    const auto narrow = static_cast<int64_t>(a);
    return narrow == a ? narrow / d : a / d;
  }
  static int Sign(Wide a) { return a < 0 ? -1 : (a > 0 ? 1 : 0); }
  static int Sign(int64_t a) { return a < 0 ? -1 : (a > 0 ? 1 : 0); }
};

template <>
struct SimplexNumber<Integer> {
  using Wide = Integer;
  static Wide Multiply(const Integer& a, const Integer& b) { return a * b; }
  static bool Narrow(const Wide& a, Integer& out) {
    out = a;
    return true;
  }
  static Wide Divide(const Wide& a, const Integer& d) { return DivideExactly(a, d); }
  static int Sign(const Integer& a) { return a.sign(); }
};

/// A proof step: determinant * row = sum over slots of coefficients[slot] * (basis row of the slot), where
/// the slots dropped by this step have negative coefficients, those dropped before any, all others zero.
template <typename T>
struct VanishingStep {
  size_t row = 0;
  T determinant{};
  std::array<T, 6> coefficients{};
  std::array<size_t, 6> basis{};
  std::array<bool, 6> dropped_before{};
};

template <typename T>
class DualSimplex {
 public:
  static constexpr int kMaxColumns = 6;
  static constexpr size_t kNoRow = std::numeric_limits<size_t>::max();
  enum class Status { kDone, kOverflow };

  /// Rows of `columns` numbers each, row major, `stride` apart; no zero row. Keeps the pointer until the
  /// results are read. steps, if given, collects the proof that the vanishing rows vanish.
  Status Solve(const T* rows, size_t count, int columns, size_t stride,
               std::vector<VanishingStep<T>>* steps = nullptr);

  /// Rank only, of the rows whose flag is `wanted` (flags may be null: all rows).
  Status Rank(const T* rows, size_t count, int columns, size_t stride,
              const std::vector<char>* flags = nullptr);

  int rank() const { return rank_; }
  /// Rank of the vanishing rows: the codimension of the cone.
  int vanishing_rank() const { return vanishing_rank_; }
  /// Per row, whether it vanishes on the whole cone.
  const std::vector<char>& vanishing() const { return vanishing_; }
  /// A point of the cone's relative interior: A x > 0 on every row that does not vanish.
  std::array<T, kMaxColumns> interior_point() const;

 private:
  using Number = SimplexNumber<T>;
  using Wide = typename Number::Wide;
  // Pivots with the largest violation before Bland's rule takes over; typical runs need fewer than 10.
  static constexpr int kPatience = 60;
  enum class Slot : char { kFree, kActive, kDropped };

  const T* row(size_t i) const { return rows_ + i * stride_; }
  void Start(const T* rows, size_t count, int columns, size_t stride);
  Wide Coefficient(const T* a, int slot) const;
  bool BuildBasis(const std::vector<char>* flags);
  bool Enter(size_t i, int slot, const std::array<T, kMaxColumns>& c, bool costs);
  void StartCosts();
  size_t MostViolated(bool first);
  bool Coefficients(size_t i, bool all, std::array<T, kMaxColumns>& c) const;
  int LeavingSlot(const std::array<T, kMaxColumns>& c) const;
  bool Drop(size_t i, const std::array<T, kMaxColumns>& c, std::vector<VanishingStep<T>>* steps);
  bool Log(size_t i, const std::array<bool, kMaxColumns>& dropped_before,
           std::vector<VanishingStep<T>>* steps) const;

  const T* rows_ = nullptr;
  size_t count_ = 0;
  size_t stride_ = 0;
  int columns_ = 0;
  int rank_ = 0;
  int vanishing_rank_ = 0;
  bool keep_all_columns_ = false;
  T determinant_{};
  // inverse_[slot] is column `slot` of M; the entry at kMaxColumns is the slot's scaled cost.
  std::array<std::array<T, kMaxColumns + 1>, kMaxColumns> inverse_{};
  std::array<size_t, kMaxColumns> basis_{};
  std::array<Slot, kMaxColumns> slots_{};
  std::vector<char> vanishing_;
};

template <typename T>
void DualSimplex<T>::Start(const T* rows, size_t count, int columns, size_t stride) {
  rows_ = rows;
  count_ = count;
  columns_ = columns;
  stride_ = stride;
  rank_ = 0;
  vanishing_rank_ = 0;
  determinant_ = T(1);
  for (int k = 0; k < columns; ++k) {
    for (int r = 0; r <= kMaxColumns; ++r) inverse_[k][r] = T(r == k ? 1 : 0);
    basis_[k] = kNoRow;
    slots_[k] = Slot::kFree;
  }
}

template <typename T>
typename DualSimplex<T>::Wide DualSimplex<T>::Coefficient(const T* a, int slot) const {
  Wide sum = Number::Multiply(a[0], inverse_[slot][0]);
  for (int r = 1; r < columns_; ++r) sum += Number::Multiply(a[r], inverse_[slot][r]);
  return sum;
}

// Fills free slots with independent rows, first come first served.
template <typename T>
bool DualSimplex<T>::BuildBasis(const std::vector<char>* flags) {
  std::array<T, kMaxColumns> c{};
  for (size_t i = 0; i < count_ && rank_ < columns_; ++i) {
    if (flags != nullptr && (*flags)[i] == 0) continue;
    int slot = -1;
    for (int k = 0; k < columns_ && slot < 0; ++k) {
      if (slots_[k] == Slot::kFree && Number::Sign(Coefficient(row(i), k)) != 0) slot = k;
    }
    if (slot < 0) continue;
    if (!Coefficients(i, /*all=*/true, c) || !Enter(i, slot, c, /*costs=*/false)) return false;
    slots_[slot] = Slot::kActive;
    ++rank_;
  }
  return true;
}

// The coefficients of row i in the basis, times the determinant; of active slots only unless all.
template <typename T>
bool DualSimplex<T>::Coefficients(size_t i, bool all, std::array<T, kMaxColumns>& c) const {
  for (int k = 0; k < columns_; ++k) {
    if (!all && slots_[k] != Slot::kActive) {
      c[k] = T(0);
    } else if (!Number::Narrow(Coefficient(row(i), k), c[k])) {
      return false;
    }
  }
  return true;
}

// Row i takes the slot; the determinant stays positive.
template <typename T>
bool DualSimplex<T>::Enter(size_t i, int slot, const std::array<T, kMaxColumns>& c, bool costs) {
  const T old = determinant_;
  const bool negative = Number::Sign(c[slot]) < 0;
  const T pivot = negative ? T(T(0) - c[slot]) : c[slot];
  const int entries = costs ? kMaxColumns + 1 : columns_;
  for (int k = 0; k < columns_; ++k) {
    if (k == slot || (costs && !keep_all_columns_ && slots_[k] != Slot::kActive)) continue;
    const T factor = negative ? T(T(0) - c[k]) : c[k];
    for (int r = 0; r < entries; ++r) {
      if (r == columns_ && costs) r = kMaxColumns;
      const Wide value =
          Number::Multiply(pivot, inverse_[k][r]) - Number::Multiply(factor, inverse_[slot][r]);
      if (!Number::Narrow(Number::Divide(value, old), inverse_[k][r])) return false;
    }
  }
  if (negative) {
    for (int r = 0; r < entries; ++r) inverse_[slot][r] = T(T(0) - inverse_[slot][r]);
  }
  determinant_ = pivot;
  basis_[slot] = i;
  return true;
}

// Every basis row costs one: the scaled cost of a slot is the determinant.
template <typename T>
void DualSimplex<T>::StartCosts() {
  for (int k = 0; k < columns_; ++k) inverse_[k][kMaxColumns] = determinant_;
}

// The row that the present point violates most (or the first such row); kNoRow if none.
template <typename T>
size_t DualSimplex<T>::MostViolated(bool first) {
  const std::array<T, kMaxColumns> x = interior_point();
  size_t found = kNoRow;
  Wide worst{};
  for (size_t i = 0; i < count_; ++i) {
    if (vanishing_[i] != 0) continue;
    const T* a = row(i);
    Wide value = Number::Multiply(a[0], x[0]);
    for (int r = 1; r < columns_; ++r) value += Number::Multiply(a[r], x[r]);
    if (Number::Sign(value) > 0 || (found != kNoRow && !(value < worst))) continue;
    found = i;
    worst = value;
    if (first) break;
  }
  return found;
}

// The slot with the smallest cost per unit, the smallest row index on a tie; -1 if no coefficient is
// positive.
template <typename T>
int DualSimplex<T>::LeavingSlot(const std::array<T, kMaxColumns>& c) const {
  int best = -1;
  for (int k = 0; k < columns_; ++k) {
    if (slots_[k] != Slot::kActive || Number::Sign(c[k]) <= 0) continue;
    if (best < 0) {
      best = k;
      continue;
    }
    const Wide difference = Number::Multiply(inverse_[k][kMaxColumns], c[best]) -
                            Number::Multiply(inverse_[best][kMaxColumns], c[k]);
    const int order = Number::Sign(difference);
    if (order < 0 || (order == 0 && basis_[k] < basis_[best])) best = k;
  }
  return best;
}

template <typename T>
bool DualSimplex<T>::Log(size_t i, const std::array<bool, kMaxColumns>& dropped_before,
                         std::vector<VanishingStep<T>>* steps) const {
  if (steps == nullptr) return true;
  VanishingStep<T> step;
  step.row = i;
  step.determinant = determinant_;
  if (!Coefficients(i, /*all=*/true, step.coefficients)) return false;
  step.basis = basis_;
  step.dropped_before = dropped_before;
  steps->push_back(step);
  return true;
}

// Row i and the basis rows with negative coefficients vanish; so does every row that is zero on what is left.
template <typename T>
bool DualSimplex<T>::Drop(size_t i, const std::array<T, kMaxColumns>& c,
                          std::vector<VanishingStep<T>>* steps) {
  std::array<bool, kMaxColumns> dropped{};
  for (int k = 0; k < columns_; ++k) dropped[k] = slots_[k] == Slot::kDropped;
  if (!Log(i, dropped, steps)) return false;
  vanishing_[i] = 1;
  for (int k = 0; k < columns_; ++k) {
    if (slots_[k] != Slot::kActive || Number::Sign(c[k]) >= 0) continue;
    slots_[k] = Slot::kDropped;
    dropped[k] = true;
    vanishing_[basis_[k]] = 1;
    ++vanishing_rank_;
  }
  for (size_t j = 0; j < count_; ++j) {
    if (vanishing_[j] != 0) continue;
    bool zero = true;
    for (int k = 0; k < columns_ && zero; ++k) {
      zero = slots_[k] != Slot::kActive || Number::Sign(Coefficient(row(j), k)) == 0;
    }
    if (!zero) continue;
    vanishing_[j] = 1;
    if (!Log(j, dropped, steps)) return false;
  }
  return true;
}

template <typename T>
std::array<T, DualSimplex<T>::kMaxColumns> DualSimplex<T>::interior_point() const {
  std::array<T, kMaxColumns> x{};
  for (int k = 0; k < columns_; ++k) {
    if (slots_[k] != Slot::kActive) continue;
    for (int r = 0; r < columns_; ++r) x[r] += inverse_[k][r];
  }
  return x;
}

template <typename T>
typename DualSimplex<T>::Status DualSimplex<T>::Solve(const T* rows, size_t count, int columns, size_t stride,
                                                      std::vector<VanishingStep<T>>* steps) {
  Start(rows, count, columns, stride);
  keep_all_columns_ = steps != nullptr;
  vanishing_.assign(count, 0);
  if (!BuildBasis(nullptr)) return Status::kOverflow;
  StartCosts();
  std::array<T, kMaxColumns> c{};
  for (int pivots = 0;; ++pivots) {
    const size_t i = MostViolated(/*first=*/pivots >= kPatience);
    if (i == kNoRow) return Status::kDone;
    if (!Coefficients(i, keep_all_columns_, c)) return Status::kOverflow;
    const int slot = LeavingSlot(c);
    const bool done = slot < 0 ? Drop(i, c, steps) : Enter(i, slot, c, /*costs=*/true);
    if (!done) return Status::kOverflow;
  }
}

template <typename T>
typename DualSimplex<T>::Status DualSimplex<T>::Rank(const T* rows, size_t count, int columns, size_t stride,
                                                     const std::vector<char>* flags) {
  Start(rows, count, columns, stride);
  return BuildBasis(flags) ? Status::kDone : Status::kOverflow;
}

}  // namespace tact::algebra

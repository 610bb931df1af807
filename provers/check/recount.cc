#include "provers/check/recount.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tact::check {
namespace {

using Small = std::int64_t;
struct Overflow {};

// p a - q b
Small Combine(Small p, Small a, Small q, Small b) {
  Small left, right, result;
  if (__builtin_mul_overflow(p, a, &left) || __builtin_mul_overflow(q, b, &right) ||
      __builtin_sub_overflow(left, right, &result)) {
    throw Overflow{};
  }
  return result;
}

constexpr std::size_t kWidth = 6;
using SmallRow = std::array<Small, kWidth>;

// Brings rows to echelon form in their first six columns, one after the other; further columns come along.
template <std::size_t columns>
class Elimination {
 public:
  using Line = std::array<Small, columns>;

  // Whether the row is independent of those before; otherwise reduced() is what became of it.
  bool Add(Line line) {
    for (std::size_t i = 0; i < rank_; ++i) {
      const Line& pivot = pivots_[i];
      const Small lead = pivot[leads_[i]], factor = line[leads_[i]];
      if (factor == 0) continue;
      for (std::size_t j = 0; j < columns; ++j) line[j] = Combine(lead, line[j], factor, pivot[j]);
    }
    std::size_t lead = 0;
    while (lead < kWidth && line[lead] == 0) ++lead;
    reduced_ = line;
    if (lead == kWidth) return false;
    pivots_[rank_] = line;
    leads_[rank_++] = lead;
    return true;
  }
  int rank() const { return static_cast<int>(rank_); }
  const Line& reduced() const { return reduced_; }

 private:
  std::array<Line, kWidth> pivots_;
  std::array<std::size_t, kWidth> leads_;
  Line reduced_;
  std::size_t rank_ = 0;
};

// Sets of rows are bits.
using Set = unsigned;

int RankOf(const std::vector<SmallRow>& rows, Set set = ~Set{0}) {
  Elimination<kWidth> elimination;
  for (std::size_t i = 0; i < rows.size() && elimination.rank() < static_cast<int>(kWidth); ++i) {
    if (i >= 32 || (set >> i & 1) != 0) elimination.Add(rows[i]);
  }
  return elimination.rank();
}

// The last row of the set must be the first that depends on those before, with coefficients of one sign.
bool IsPositiveCircuit(const std::vector<SmallRow>& rows, Set set) {
  constexpr std::size_t kColumns = kWidth + kMaxRecountLargest;
  Elimination<kColumns> elimination;
  std::size_t size = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if ((set >> i & 1) == 0) continue;
    std::array<Small, kColumns> line{};
    std::copy(rows[i].begin(), rows[i].end(), line.begin());
    line[kWidth + size++] = 1;
    if (elimination.Add(line)) continue;
    if (i + 1 != rows.size()) return false;
    const auto first = elimination.reduced().begin() + kWidth, last = first + static_cast<long>(size);
    return std::all_of(first, last, [](Small y) { return y > 0; }) ||
           std::all_of(first, last, [](Small y) { return y < 0; });
  }
  return false;
}

// The rows of positive circuits that the last row belongs to.
Set CircuitsOfLast(const std::vector<SmallRow>& rows) {
  Set found = 0;
  const Set last = Set{1} << (rows.size() - 1);
  for (Set others = 1; others < last; ++others) {
    if (((others | last) & ~found) != 0 && IsPositiveCircuit(rows, others | last)) found |= others | last;
  }
  return found;
}

SmallRow ForceOf(const SmallRow& row) { return {0, 0, 0, row[3], row[4], row[5]}; }

class Walk {
 public:
  Walk(const std::vector<ContactNumbers>& contacts, std::size_t largest) : largest_(largest) {
    for (const ContactNumbers& contact : contacts) {
      auto& rows = contacts_.emplace_back();
      for (const Row& row : contact.rows) {
        SmallRow& small = rows.emplace_back();
        for (std::size_t j = 0; j < kWidth; ++j) {
          if (!row[j].fits_slong_p()) throw Overflow{};
          small[j] = row[j].get_si();
        }
      }
    }
  }

  // All multisets that begin with the chosen contacts and go on with those from `first`.
  void Visit(std::size_t first, Set in_all, Set in_translation) {
    ++counts_[Numbers(in_all, in_translation)];
    if (chosen_ == largest_) return;
    ++chosen_;
    for (std::size_t i = first; i < contacts_.size(); ++i) {
      const auto& rows = contacts_[i];
      for (const SmallRow& row : rows) {
        planes_.push_back(row);
        plane_forces_.push_back(ForceOf(row));
      }
      if (rows.size() == 1) {
        single_.push_back(rows[0]);
        forces_.push_back(ForceOf(rows[0]));
        Visit(i, in_all | CircuitsOfLast(single_), in_translation | CircuitsOfLast(forces_));
        single_.pop_back();
        forces_.pop_back();
      } else {
        ++singular_;
        Visit(i, in_all, in_translation);
        --singular_;
      }
      planes_.resize(planes_.size() - rows.size());
      plane_forces_.resize(planes_.size());
    }
    --chosen_;
  }

  std::map<MotionNumbers, std::size_t> counts() const {
    std::map<MotionNumbers, std::size_t> counts;
    for (const auto& [ranks, count] : counts_) counts[FromRanks(ranks)] += count;
    return counts;
  }

 private:
  Ranks Numbers(Set in_all, Set in_translation) const {
    return {singular_ > 0,
            RankOf(single_),
            RankOf(forces_),
            RankOf(single_, in_all),
            RankOf(forces_, in_all),
            RankOf(single_, in_translation),
            RankOf(forces_, in_translation),
            RankOf(planes_),
            RankOf(plane_forces_)};
  }

  std::vector<std::vector<SmallRow>> contacts_;
  std::size_t largest_, chosen_ = 0, singular_ = 0;
  std::vector<SmallRow> single_, forces_, planes_, plane_forces_;  // of the chosen contacts
  std::map<Ranks, std::size_t> counts_;
};

}  // namespace

mpz_class MultisetCount(std::size_t contacts, std::size_t largest) {
  mpz_class count;  // binomial(contacts + largest, largest)
  mpz_bin_uiui(count.get_mpz_t(), contacts + largest, largest);
  return count;
}

std::optional<std::map<MotionNumbers, std::size_t>> Recount(const std::vector<ContactNumbers>& contacts,
                                                            std::size_t largest) {
  try {
    Walk walk(contacts, largest);
    walk.Visit(0, 0, 0);
    return walk.counts();
  } catch (const Overflow&) {
    return std::nullopt;
  }
}

}  // namespace tact::check

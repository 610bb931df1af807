#include "enumerators/dof_census.h"

#include <algorithm>
#include <limits>
#include <string>

#include "algebra/contact/contact_rows.h"
#include "algebra/error.h"

namespace tact::enumerators {
namespace {

constexpr uint64_t kMostRelations = uint64_t{1} << 63;

std::vector<int64_t> RowsOf(const ContactWorld& world) {
  std::vector<int64_t> rows;
  for (const algebra::Contact& contact : world.contacts) {
    if (contact.singular()) throw PreconditionError("a census of DOF classes takes contacts with one plane");
    algebra::ContactRows row;
    row.Assign({{contact}});
    if (!row.is_small()) throw PreconditionError("a census of DOF classes takes contacts of 64-bit numbers");
    rows.insert(rows.end(), row.small().begin(), row.small().end());
  }
  return rows;
}

// The next set of `set.size()` of n contacts; false if it was the last.
bool NextOfSize(std::vector<size_t>& set, size_t n) {
  for (size_t i = set.size(); i-- > 0;) {
    if (set[i] == n - set.size() + i) continue;
    ++set[i];
    for (size_t j = i + 1; j < set.size(); ++j) set[j] = set[j - 1] + 1;
    return true;
  }
  return false;
}

}  // namespace

bool ComesBefore(const std::vector<size_t>& a, const std::vector<size_t>& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

DofCensus::DofCensus(ContactWorld world) : world_(std::move(world)), rows_(RowsOf(world_)) {
  const size_t n = world_.contacts.size();
  world_.largest = std::min(world_.largest, n);
  choose_.assign(n + 1, std::vector<uint64_t>(world_.largest + 1, 0));
  for (size_t i = 0; i <= n; ++i) {
    choose_[i][0] = 1;
    for (size_t k = 1; k <= std::min(i, world_.largest); ++k) {
      choose_[i][k] = choose_[i - 1][k - 1] + choose_[i - 1][k];
      if (choose_[i][k] >= kMostRelations) throw PreconditionError("a world of more than 2^63 relations");
    }
  }
  for (size_t k = 0; k <= world_.largest; ++k) {
    smaller_.push_back(relations_);
    relations_ += choose_[n][k];
    if (relations_ >= kMostRelations) throw PreconditionError("a world of more than 2^63 relations");
  }
}

std::vector<size_t> DofCensus::Unrank(uint64_t rank) const {
  const size_t n = world_.contacts.size();
  size_t size = world_.largest;
  while (smaller_[size] > rank) --size;
  rank -= smaller_[size];
  std::vector<size_t> set;
  for (size_t i = 0; set.size() < size; ++i) {
    const uint64_t with_i = choose_[n - 1 - i][size - set.size() - 1];
    if (rank < with_i) {
      set.push_back(i);
    } else {
      rank -= with_i;
    }
  }
  return set;
}

DofCounts DofCensus::CountUnit(size_t unit) const {
  if (unit >= units())
    throw PreconditionError("no unit " + std::to_string(unit) + " of " + std::to_string(units()));
  return CountRange(unit * kUnitSize, std::min(relations_, (unit + 1) * kUnitSize));
}

DofCounts DofCensus::CountRange(uint64_t first, uint64_t last) const {
  if (first > last || last > relations_) {
    throw PreconditionError("no relations " + std::to_string(first) + " to " + std::to_string(last) + " of " +
                            std::to_string(relations_));
  }
  DofCounts counts;
  if (first == last) return counts;
  std::vector<size_t> set = Unrank(first);
  algebra::MotionDofEngine engine;
  std::vector<int64_t> rows;
  for (uint64_t rank = first; rank < last; ++rank) {
    rows.clear();
    for (const size_t i : set) rows.insert(rows.end(), rows_.begin() + 6 * i, rows_.begin() + 6 * i + 6);
    const algebra::MotionDof dof = engine.Compute(rows);
    auto at = std::lower_bound(counts.begin(), counts.end(), dof,
                               [](const DofCount& c, const algebra::MotionDof& d) { return c.dof < d; });
    if (at == counts.end() || at->dof != dof) at = counts.insert(at, {dof, 0, set});
    ++at->count;
    if (!NextOfSize(set, world_.contacts.size())) {
      set.resize(set.size() + 1);
      for (size_t i = 0; i < set.size(); ++i) set[i] = i;
    }
  }
  return counts;
}

void DofCensus::Merge(DofCounts& total, const DofCounts& part) {
  for (const DofCount& count : part) {
    auto at = std::lower_bound(total.begin(), total.end(), count.dof,
                               [](const DofCount& c, const algebra::MotionDof& d) { return c.dof < d; });
    if (at == total.end() || at->dof != count.dof) {
      total.insert(at, count);
      continue;
    }
    at->count += count.count;
    if (ComesBefore(count.witness, at->witness)) at->witness = count.witness;
  }
}

DofCounts DofCensus::Count() const {
  DofCounts total;
  for (size_t unit = 0; unit < units(); ++unit) Merge(total, CountUnit(unit));
  return total;
}

algebra::ContactRelation DofCensus::Relation(const std::vector<size_t>& contacts) const {
  algebra::ContactRelation relation;
  for (const size_t i : contacts) relation.contacts.push_back(world_.contacts.at(i));
  return relation;
}

}  // namespace tact::enumerators

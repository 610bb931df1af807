#include "enumerators/dof_census.h"

#include <algorithm>
#include <string>

#include "algebra/error.h"

namespace tact::enumerators {
DofCensus::DofCensus(ContactWorld world)
    : world_(std::move(world)), rows_(WorldRows(world_)), sets_(world_.contacts.size(), world_.largest) {
  world_.largest = std::min(world_.largest, world_.contacts.size());
}

DofCounts DofCensus::CountUnit(size_t unit) const {
  if (unit >= units())
    throw PreconditionError("no unit " + std::to_string(unit) + " of " + std::to_string(units()));
  return CountRange(unit * kUnitSize, std::min(relations(), (unit + 1) * kUnitSize));
}

DofCounts DofCensus::CountRange(uint64_t first, uint64_t last) const {
  if (first > last || last > relations()) {
    throw PreconditionError("no relations " + std::to_string(first) + " to " + std::to_string(last) + " of " +
                            std::to_string(relations()));
  }
  DofCounts counts;
  if (first == last) return counts;
  std::vector<size_t> set = sets_.At(first);
  algebra::MotionDofEngine engine;
  std::vector<int64_t> rows;
  for (uint64_t number = first; number < last; ++number, sets_.Advance(set)) {
    rows.clear();
    for (const size_t i : set) rows.insert(rows.end(), rows_.begin() + 6 * i, rows_.begin() + 6 * i + 6);
    const algebra::MotionDof dof = engine.Compute(rows);
    auto at = std::lower_bound(counts.begin(), counts.end(), dof,
                               [](const DofCount& c, const algebra::MotionDof& d) { return c.dof < d; });
    if (at == counts.end() || at->dof != dof) at = counts.insert(at, {dof, 0, set});
    ++at->count;
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

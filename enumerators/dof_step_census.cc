#include "enumerators/dof_step_census.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "enumerators/dof_class.h"

namespace tact::enumerators {
namespace {

auto KeyOf(const DofStep& step) { return std::tuple(step.kind, step.before, step.after); }

// The steps met so far, each kind once.
class StepTable {
 public:
  explicit StepTable(size_t classes) : classes_(classes), slots_(kAdditionKinds * classes * classes, kNone) {}

  void Add(const Addition& addition, size_t before, size_t after, const std::vector<size_t>& relation) {
    size_t& slot = slots_[(static_cast<size_t>(addition.kind) * classes_ + before) * classes_ + after];
    if (slot == kNone) {
      slot = steps_.size();
      steps_.push_back({addition.kind, before, after, 0, {relation, addition.contacts}});
    }
    ++steps_[slot].count;
  }

  DofSteps Finish() {
    std::sort(steps_.begin(), steps_.end(),
              [](const DofStep& a, const DofStep& b) { return KeyOf(a) < KeyOf(b); });
    return std::move(steps_);
  }

 private:
  static constexpr size_t kNone = std::numeric_limits<size_t>::max();

  size_t classes_;
  std::vector<size_t> slots_;
  DofSteps steps_;
};

class Classifier {
 public:
  explicit Classifier(const std::vector<int64_t>& rows) : world_rows_(rows), classes_(DofClasses()) {}

  size_t classes() const { return classes_.size(); }
  void Clear() { rows_.clear(); }
  void Push(const std::vector<size_t>& contacts) {
    for (const size_t i : contacts) {
      const auto row = world_rows_.begin() + static_cast<std::ptrdiff_t>(6 * i);
      rows_.insert(rows_.end(), row, row + 6);
    }
  }
  void Pop(size_t contacts) { rows_.resize(rows_.size() - 6 * contacts); }
  // The class of the contacts that were pushed.
  size_t Class() {
    const algebra::MotionDof dof = engine_.Compute(rows_);
    const auto at = std::lower_bound(classes_.begin(), classes_.end(), dof);
    if (at == classes_.end() || *at != dof) throw InvariantError("a relation of none of the DOF classes");
    return static_cast<size_t>(at - classes_.begin());
  }

 private:
  const std::vector<int64_t>& world_rows_;
  const std::vector<algebra::MotionDof> classes_;
  std::vector<int64_t> rows_;
  algebra::MotionDofEngine engine_;
};

ContactWorld WithSteps(ContactWorld world) {
  world.largest = std::min(world.largest, world.contacts.size());
  if (world.largest == 0) throw PreconditionError("steps between contact relations take a contact at least");
  return world;
}

}  // namespace

bool ComesBefore(const StepWitness& a, const StepWitness& b) {
  return a.relation != b.relation ? ComesBefore(a.relation, b.relation) : ComesBefore(a.added, b.added);
}

DofStepCensus::DofStepCensus(ContactWorld world)
    : world_(WithSteps(std::move(world))),
      rows_(WorldRows(world_)),
      sets_(world_.contacts.size(), world_.largest - 1),
      additions_(Additions(world_)) {}

double DofStepCensus::steps_at_most() const {
  return static_cast<double>(relations()) * static_cast<double>(additions_.size());
}

uint64_t DofStepCensus::relations_in_a_unit() const {
  return std::max<uint64_t>(1, kUnitSteps / additions_.size());
}

DofSteps DofStepCensus::CountUnit(size_t unit) const {
  if (unit >= units())
    throw PreconditionError("no unit " + std::to_string(unit) + " of " + std::to_string(units()));
  const uint64_t size = relations_in_a_unit();
  return CountRange(unit * size, std::min(relations(), (unit + 1) * size));
}

DofSteps DofStepCensus::CountRange(uint64_t first, uint64_t last) const {
  if (first > last || last > relations()) {
    throw PreconditionError("no relations " + std::to_string(first) + " to " + std::to_string(last) + " of " +
                            std::to_string(relations()));
  }
  if (first == last) return {};
  Classifier classifier(rows_);
  StepTable table(classifier.classes());
  std::vector<char> taken(world_.contacts.size(), 0);
  std::vector<size_t> relation = sets_.At(first);
  for (uint64_t number = first; number < last; ++number, sets_.Advance(relation)) {
    classifier.Clear();
    classifier.Push(relation);
    const size_t before = classifier.Class();
    for (const size_t i : relation) taken[i] = 1;
    for (const Addition& addition : additions_) {
      if (std::ranges::any_of(addition.contacts, [&](size_t i) { return taken[i] != 0; })) continue;
      classifier.Push(addition.contacts);
      table.Add(addition, before, classifier.Class(), relation);
      classifier.Pop(addition.contacts.size());
    }
    for (const size_t i : relation) taken[i] = 0;
  }
  return table.Finish();
}

void DofStepCensus::Merge(DofSteps& total, const DofSteps& part) {
  DofSteps merged;
  merged.reserve(std::max(total.size(), part.size()));
  auto ours = total.begin();
  for (const DofStep& step : part) {
    while (ours != total.end() && KeyOf(*ours) < KeyOf(step)) merged.push_back(std::move(*ours++));
    if (ours == total.end() || KeyOf(*ours) != KeyOf(step)) {
      merged.push_back(step);
      continue;
    }
    DofStep& both = merged.emplace_back(std::move(*ours++));
    both.count += step.count;
    if (ComesBefore(step.witness, both.witness)) both.witness = step.witness;
  }
  merged.insert(merged.end(), std::make_move_iterator(ours), std::make_move_iterator(total.end()));
  total = std::move(merged);
}

DofSteps DofStepCensus::Count() const {
  DofSteps total;
  for (size_t unit = 0; unit < units(); ++unit) Merge(total, CountUnit(unit));
  return total;
}

algebra::ContactRelation DofStepCensus::Relation(const std::vector<size_t>& contacts) const {
  algebra::ContactRelation relation;
  for (const size_t i : contacts) relation.contacts.push_back(world_.contacts.at(i));
  return relation;
}

}  // namespace tact::enumerators

/// @file
/// The steps between DOF classes in a finite world: a contact, an edge or a face is added to a contact relation.
/// Model   A step is a relation and an addition (contact_additions.h) none of whose contacts the relation has. Relations are
///         sets of fewer than `largest` contacts of the world, in canonical order (contact_sets.h). Steps are counted by
///         addition and by the classes before and after, numbered as in DofClasses(); equal ones are counted, too. A
///         witness is the first step of its kind: the first relation, then the first addition.
///         Removing contacts is the same read backwards: from `after` to `before`.
/// Units   The relations are cut into units of about kUnitSteps steps; units can be counted in any order, by any
///         number of threads or machines, and merged: the result is the same.
/// Cost    about 2 microseconds a step; a kind of step allocates when a unit first meets it, a step never.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "enumerators/contact_additions.h"
#include "enumerators/contact_sets.h"

namespace tact::enumerators {

struct StepWitness {
  std::vector<size_t> relation, added;  // indices of the world's contacts, increasing
  friend bool operator==(const StepWitness&, const StepWitness&) = default;
};
/// By relation, then by what is added, in canonical order.
bool ComesBefore(const StepWitness& a, const StepWitness& b);

struct DofStep {
  AdditionKind kind = AdditionKind::kContact;
  size_t before = 0, after = 0;  // of DofClasses()
  uint64_t count = 0;
  StepWitness witness;
  friend bool operator==(const DofStep&, const DofStep&) = default;
};
/// By kind, before, after.
using DofSteps = std::vector<DofStep>;

class DofStepCensus {
 public:
  static constexpr uint64_t kUnitSteps = 500000;

  /// PreconditionError: no contact, a singular one, numbers beyond 64 bits, more relations than 2^63.
  explicit DofStepCensus(ContactWorld world);

  const ContactWorld& world() const { return world_; }
  const std::vector<Addition>& additions() const { return additions_; }
  /// Sets of fewer than `largest` contacts.
  uint64_t relations() const { return sets_.size(); }
  /// Relations times additions, some of which share contacts: a bound on the steps.
  double steps_at_most() const;
  uint64_t relations_in_a_unit() const;
  size_t units() const {
    return static_cast<size_t>((relations() + relations_in_a_unit() - 1) / relations_in_a_unit());
  }

  /// PreconditionError: no such unit.
  DofSteps CountUnit(size_t unit) const;
  /// From relation number `first` up to and without number `last`. PreconditionError: there are fewer.
  DofSteps CountRange(uint64_t first, uint64_t last) const;
  /// Adds the part's counts; of two witnesses the one that comes first stays.
  static void Merge(DofSteps& total, const DofSteps& part);
  /// The whole census on this thread.
  DofSteps Count() const;

  algebra::ContactRelation Relation(const std::vector<size_t>& contacts) const;

 private:
  ContactWorld world_;
  std::vector<int64_t> rows_;  // six a contact
  ContactSets sets_;
  std::vector<Addition> additions_;
};

/// A JSON list, a line a step: {"added":"edge","before":N,"after":N,"count":N,"relation":[...],"contacts":[...]}.
std::string ToText(const DofSteps& steps);
/// Reads just what ToText writes. InputError: anything else, with the place in the text.
DofSteps ParseDofSteps(std::string_view text);
/// {"kind":"dof-transitions",...}: as DescribeCensus in dof_counts_text.h.
std::string DescribeCensus(const DofStepCensus& census, const std::string& world, const std::string& version);

}  // namespace tact::enumerators

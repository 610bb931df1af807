/// @file
/// The DOF classes that a finite world of contacts has, with how many relations each and a smallest witness.
/// Model   A relation here is a set of at most `largest` contacts of the world, none twice, in canonical order
///         (contact_sets.h). A witness is the first of its class.
/// Units   The order is cut into units of kUnitSize relations; units can be counted in any order, by any number of
///         threads or machines, and merged: the result is the same.
/// Cost    about 2 microseconds a relation of 8 contacts; a unit allocates a few times, a relation not at all.
#pragma once

#include <cstdint>
#include <vector>

#include "algebra/contact/motion_dof.h"
#include "enumerators/contact_sets.h"

namespace tact::enumerators {

struct DofCount {
  algebra::MotionDof dof;
  uint64_t count = 0;
  std::vector<size_t> witness;  // indices of the world's contacts, increasing
  friend bool operator==(const DofCount&, const DofCount&) = default;
};
/// By increasing DOFs.
using DofCounts = std::vector<DofCount>;

class DofCensus {
 public:
  static constexpr uint64_t kUnitSize = 250000;

  /// PreconditionError: a singular contact, numbers beyond 64 bits, more relations than 2^63.
  explicit DofCensus(ContactWorld world);

  const ContactWorld& world() const { return world_; }
  /// Sets of at most `largest` contacts.
  uint64_t relations() const { return sets_.size(); }
  size_t units() const { return static_cast<size_t>((relations() + kUnitSize - 1) / kUnitSize); }

  /// The relations from unit * kUnitSize on. PreconditionError: no such unit.
  DofCounts CountUnit(size_t unit) const;
  /// The relations from number `first` up to and without number `last`. PreconditionError: there are fewer.
  DofCounts CountRange(uint64_t first, uint64_t last) const;
  /// Adds the part's counts; of two witnesses the one that comes first stays.
  static void Merge(DofCounts& total, const DofCounts& part);
  /// The whole census on this thread.
  DofCounts Count() const;

  algebra::ContactRelation Relation(const std::vector<size_t>& contacts) const;

 private:
  ContactWorld world_;
  std::vector<int64_t> rows_;  // six a contact
  ContactSets sets_;
};

}  // namespace tact::enumerators

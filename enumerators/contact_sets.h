/// @file
/// The contact relations of a finite world that are sets, in canonical order, by number.
/// Model   A relation is a set of at most so many of a world's contacts, none twice, as increasing indices. Canonical order:
///         fewer contacts first, then lexicographic.
#pragma once

#include <cstdint>
#include <vector>

#include "enumerators/contact_world.h"

namespace tact::enumerators {

class ContactSets {
 public:
  /// Sets of at most `largest` of `contacts`. PreconditionError: more than 2^63.
  ContactSets(size_t contacts, size_t largest);

  uint64_t size() const { return size_; }
  /// PreconditionError: no such number.
  std::vector<size_t> At(uint64_t number) const;
  /// The set after it in the order, in its place; of the last one, the first of more contacts.
  void Advance(std::vector<size_t>& set) const;

 private:
  size_t contacts_, largest_;
  std::vector<std::vector<uint64_t>> choose_;  // choose_[n][k]
  std::vector<uint64_t> smaller_;              // sets of fewer than k contacts
  uint64_t size_ = 0;
};

/// Whether one set comes before another in canonical order.
bool ComesBefore(const std::vector<size_t>& a, const std::vector<size_t>& b);

/// Six numbers a contact, its row (algebra/contact/contact_rows.h). PreconditionError: a singular contact, numbers
/// beyond 64 bits.
std::vector<int64_t> WorldRows(const ContactWorld& world);

}  // namespace tact::enumerators

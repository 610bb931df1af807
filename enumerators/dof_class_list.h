/// @file
/// A census sorted by each definition of a DOF class: which classes were found, how often, with which smallest
/// witness, and whether these are all that the lemmas allow.
#pragma once

#include <cstdint>
#include <vector>

#include "enumerators/dof_census.h"
#include "enumerators/dof_class.h"

namespace tact::enumerators {

struct FoundClass {
  std::vector<int> values;  // of the definition's indices
  uint64_t count = 0;       // relations
  std::vector<size_t> witness;
};

struct DofClassList {
  const DofDefinition* definition;
  std::vector<FoundClass> found;  // by increasing values
  size_t upper_bound = 0;         // what the lemmas allow

  bool complete() const { return found.size() == upper_bound; }
};

/// A list for each of DofDefinitions(), in their order. InvariantError: a class that a lemma excludes.
std::vector<DofClassList> ListDofClasses(const DofCounts& counts);

/// Whether every face that touches is parallel to a coordinate plane, so that BoxClasses() are all there can be.
bool IsBoxWorld(const ContactWorld& world);

}  // namespace tact::enumerators

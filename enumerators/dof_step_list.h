/// @file
/// A census of steps sorted by each definition of a DOF class: which pairs of classes what is added connects, how often,
/// with the first witness.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algebra/contact/dof_transition.h"
#include "enumerators/dof_class.h"
#include "enumerators/dof_step_census.h"

namespace tact::enumerators {

struct FoundStep {
  std::vector<int> from, to;  // values of the definition's indices, before and after
  uint64_t count = 0;
  StepWitness witness;
};

struct DofStepList {
  AdditionKind kind;
  const DofDefinition* definition;
  std::vector<FoundStep> found;  // by increasing from, then to; from and to differ
  uint64_t within = 0;           // steps that stay in their class

  /// All steps of that addition.
  uint64_t steps() const;
  /// From one class to another.
  uint64_t Count(const std::vector<int>& from, const std::vector<int>& to) const;
};

/// By addition, then by definition in the order of DofDefinitions().
std::vector<DofStepList> ListDofSteps(const DofSteps& steps);

/// The steps of one addition after which a motion has fewer maintaining and more constraining DOFs: some maintaining DOF
/// must have become constraining. One contact alone makes none.
struct DirectBlocks {
  AdditionKind kind;
  algebra::Motion motion;
  uint64_t steps = 0;
  std::optional<StepWitness> smallest;
};
/// By addition, then translation, rotation.
std::vector<DirectBlocks> CountDirectBlocks(const DofSteps& steps);

/// Ordered pairs of classes that an addition of any kind connects. Precondition: a number of DofDefinitions().
size_t CountPairs(const std::vector<DofStepList>& lists, size_t definition);

}  // namespace tact::enumerators

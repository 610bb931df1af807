/// @file
/// The page about steps between contact relations: between the ten kinds in translation, between the DOF classes of a
/// finite world, and the thirty DOF-transitions as real solids that move.
#pragma once

#include <string>
#include <vector>

#include "enumerators/dof_step_list.h"
#include "enumerators/translation_steps.h"
#include "provers/claims/shown_transitions.h"

namespace tact::provers {

struct DofTransitionFindings {
  const enumerators::DofStepCensus& census;
  std::vector<enumerators::DofStepList> lists;           // enumerators::ListDofSteps of it
  std::vector<enumerators::DirectBlocks> direct_blocks;  // enumerators::CountDirectBlocks of it
  std::vector<enumerators::StepDefinition> translation;  // enumerators::TranslationSteps
  std::vector<ShownScene> scenes;                        // ShowScenes
  std::vector<ShownTransition> shown;                    // ShownTransitions of them
};

std::string DofTransitionPage(const DofTransitionFindings& findings);

}  // namespace tact::provers

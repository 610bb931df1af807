/// @file
/// What the scenes of dof_transition_scenes.h show: every kind of DOF-transition, in translation and in rotation.
/// Model   A scene shows what some direction of motion does between its relations at s = 0 and s = 1, and backwards the
///         reverse (algebra/contact/dof_pairing.h). It is forced if the counts of DOFs alone say so, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "provers/claims/dof_transition_scenes.h"

namespace tact::provers {

/// "M", "D", "C", "SM", "SD", "SC".
std::string Symbol(algebra::DofIndex index);

struct ShownScene {
  DofTransitionScene given;
  algebra::ContactRelation before, after;
  algebra::MotionDof dof_before, dof_after;
  std::vector<algebra::DofTransition> by_direction, forced;  // forwards
};

/// Follows every scene's motion. InvariantError: one penetrates, or what touches changes before its end.
std::vector<ShownScene> ShowScenes();

struct ShownTransition {
  algebra::DofTransition transition;
  std::optional<size_t> scene;  // that shows it; none: no scene does
  bool backwards = false;       // the scene, read from its end
  bool forced = false;          // in that scene
};

/// Translation first, then by from, then by to: sixty. Of the scenes that show it, forced ones are preferred, then
/// the one made for it.
std::vector<ShownTransition> ShownTransitions(const std::vector<ShownScene>& scenes);

}  // namespace tact::provers

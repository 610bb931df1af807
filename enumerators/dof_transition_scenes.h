/// @file
/// Real solids and exact motions that realise the DOF-transitions, one scene for each pair of indices.
/// Model   A scene's motion keeps contact relation A for s in [0, 1) and reaches B at s = 1; run backwards it leads
///         from B to A. So fifteen scenes show all thirty ordered pairs of six indices, in translation and in rotation.
#pragma once

#include <string>
#include <vector>

#include "algebra/contact/dof_transition.h"
#include "algebra/contact/scene.h"

namespace tact::enumerators {

struct DofTransitionScene {
  algebra::DofIndex before, after;  // forwards
  std::string story;                // what moves, in a sentence
  algebra::Scene scene;
};

/// By pair of indices, in their order.
std::vector<DofTransitionScene> DofTransitionScenes();

/// A bar rolls on its bottom edge until its top edge meets the ceiling and its side a wall, both at once: a free direction
/// becomes one-sided, a one-sided one is blocked, and the counts show a free one blocked.
algebra::Scene RollIntoTheCorner();

}  // namespace tact::enumerators

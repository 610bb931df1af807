/// @file
/// From a demonstration to contact relations, DOF-transitions, sub-skills and critical transitions [thesis, 2.3-2.6, 2.8.2].
/// Model   Neighbouring states with the same contact relation are one; between two that differ stands a transition.
/// Exact   geometry alone: contacts by the contact finder, DOFs by the exact engine.
#pragma once

#include <string>
#include <vector>

#include "algebra/contact/dof_transition.h"
#include "robot/input/demonstration.h"
#include "robot/recognition/posed_models.h"

namespace tact::recognition {

struct SeenRelation {
  std::string name;            // of its first state
  size_t first = 0, last = 0;  // states, counted from 1
  algebra::ContactRelation relation;
  std::vector<algebra::ContactPrimitive> primitives;  // empty if the relation was given as such
  algebra::MotionDof dof;
};

struct Recognition {
  std::vector<SeenRelation> relations;
  std::vector<algebra::Transition> transitions;  // transitions[i] leads from relations[i] to relations[i + 1]
  std::vector<std::string> notes;
};

/// Throws InputError as posed_models.h says; a pose demonstration's files are read here.
Recognition Recognize(const input::Demonstration& demonstration);
/// The same with models already loaded.
Recognition Recognize(const ModelPair& models, const std::vector<input::NamedPose>& states);

}  // namespace tact::recognition

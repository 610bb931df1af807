/// @file
/// Two CAD models and a pose between them, to their contact relation.
/// Frames  the answer is in the fixed model's frame; X_FM is the moving model's pose in it.
/// Units   models, translations and points all in the models' unit.
/// Errors  InputError: a mesh that is refused, models that interpenetrate (how deep and where), named elements that are not
///         there or do not touch.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algebra/contact/contact_finder.h"
#include "algebra/screw/pose.h"
#include "robot/input/cad_relation.h"

namespace tact::recognition {

struct ModelPair {
  algebra::Polyhedron moving, fixed;
  cad::LengthUnit unit = cad::LengthUnit::kMillimetre;
  algebra::Rational tolerance;     // in that unit
  std::vector<std::string> notes;  // what a person should know about the models
};

/// Reads both meshes; a note tells of models whose sizes differ a hundredfold or more.
ModelPair LoadModels(const input::CadModels& models);

/// The contacts in a pose; where names the pose in errors ("file:line:column").
algebra::FoundContacts ContactsInPose(const ModelPair& models, const algebra::Pose& X_FM,
                                      const std::string& where);

/// Only those contacts that lie on both elements of one of the pairs.
algebra::ContactRelation ContactsOfElements(const ModelPair& models, const algebra::Pose& X_FM,
                                            const std::vector<input::ElementPair>& pairs,
                                            const std::string& where);

}  // namespace tact::recognition

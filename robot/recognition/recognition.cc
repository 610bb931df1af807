#include "robot/recognition/recognition.h"

#include <algorithm>

#include "algebra/contact/dof_pairing.h"
#include "robot/recognition/transition_validity.h"

namespace tact::recognition {
namespace {

// The same elements touch, in as many points with as many planes; if no elements are known, the same contacts.
bool SameRelation(const SeenRelation& a, const SeenRelation& b) {
  if (a.primitives.empty() && b.primitives.empty()) return a.relation == b.relation;
  return SameElements(a.primitives, b.primitives) && a.dof == b.dof;
}

void Append(SeenRelation next, Recognition& recognition) {
  next.dof = ComputeMotionDof(next.relation);
  auto& relations = recognition.relations;
  if (!relations.empty() && SameRelation(relations.back(), next)) {
    relations.back().last = next.last;
    return;
  }
  if (!relations.empty())
    recognition.transitions.push_back(AnalyzeTransition(relations.back().relation, next.relation));
  relations.push_back(std::move(next));
}

}  // namespace

Recognition Recognize(const ModelPair& models, const std::vector<input::NamedPose>& states) {
  Recognition recognition;
  recognition.notes = models.notes;
  for (size_t i = 0; i < states.size(); ++i) {
    const input::NamedPose& state = states[i];
    auto found = ContactsInPose(models, state.pose.pose, state.where + " (state " + state.name + ")");
    if (!state.pose.exact) {
      recognition.notes.push_back(
          "state " + state.name +
          ": its rotation was rounded to a rational one, so contacts need a tolerance");
    }
    Append({state.name, i + 1, i + 1, std::move(found.relation), std::move(found.primitives), {}},
           recognition);
  }
  return recognition;
}

Recognition Recognize(const input::Demonstration& demonstration) {
  if (const auto* poses = std::get_if<input::PoseDemonstration>(&demonstration)) {
    return Recognize(LoadModels(poses->models), poses->states);
  }
  Recognition recognition;
  const auto& relations = std::get<input::RelationDemonstration>(demonstration).relations;
  for (size_t i = 0; i < relations.size(); ++i) {
    Append({relations[i].name, i + 1, i + 1, relations[i].relation, {}, {}}, recognition);
  }
  return recognition;
}

}  // namespace tact::recognition

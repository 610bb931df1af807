#include "cli/cad_contacts.h"

#include "cli/output.h"
#include "robot/recognition/posed_models.h"

namespace tact::cli {

algebra::ContactRelation ContactsFromCad(const input::CadRelation& relation) {
  const recognition::ModelPair models = recognition::LoadModels(relation.models);
  for (const std::string& note : models.notes) Note(relation.where + ": " + note);
  if (!relation.pose.exact) {
    Note(relation.where + ": the rotation was rounded to a rational one, so contacts need a tolerance");
  }
  if (!relation.contacts) {
    return recognition::ContactsInPose(models, relation.pose.pose, relation.where).relation;
  }
  return recognition::ContactsOfElements(models, relation.pose.pose, *relation.contacts, relation.where);
}

}  // namespace tact::cli

#include "cli/cad_contacts.h"

#include "robot/recognition/posed_models.h"

namespace tact::cli {

algebra::ContactRelation ContactsFromCad(const input::CadRelation& relation) {
  const recognition::ModelPair models = recognition::LoadModels(relation.models);
  if (!relation.contacts) {
    return recognition::ContactsInPose(models, relation.pose.pose, relation.where).relation;
  }
  return recognition::ContactsOfElements(models, relation.pose.pose, *relation.contacts, relation.where);
}

}  // namespace tact::cli

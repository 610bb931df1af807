#include "enumerators/neighbour_relations.h"

namespace tact::enumerators {
namespace {

using algebra::Contact;
using algebra::ContactRelation;

void Choose(const ContactRelation& relation, size_t i, bool same, ContactRelation& before,
            const std::function<void(const ContactRelation&)>& visit) {
  if (i == relation.contacts.size()) {
    if (!same) visit(before);
    return;
  }
  const Contact& contact = relation.contacts[i];
  Choose(relation, i + 1, false, before, visit);
  before.contacts.push_back(contact);
  Choose(relation, i + 1, same, before, visit);
  for (size_t plane = 0; contact.singular() && plane < contact.planes.size(); ++plane) {
    before.contacts.back().planes = {contact.planes[plane]};
    Choose(relation, i + 1, false, before, visit);
  }
  before.contacts.pop_back();
}

}  // namespace

void ForEachRelationBefore(const ContactRelation& relation,
                           const std::function<void(const ContactRelation&)>& visit) {
  ContactRelation before;
  Choose(relation, 0, true, before, visit);
}

}  // namespace tact::enumerators

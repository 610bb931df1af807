#include "algebra/contact/contact_relation.h"

#include <algorithm>

namespace tact::algebra {

bool ContactRelation::singular() const {
  return std::any_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.singular(); });
}

ContactRelation ContactRelation::WithoutSingular() const {
  ContactRelation result;
  for (const Contact& contact : contacts) {
    if (!contact.singular()) result.contacts.push_back(contact);
  }
  return result;
}

}  // namespace tact::algebra

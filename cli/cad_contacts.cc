#include "cli/cad_contacts.h"

#include "algebra/error.h"

namespace tact::cli {

algebra::ContactRelation ContactsFromCad(const input::CadRelation& relation) {
  throw InputError(
      relation.where +
      ": expected contacts with \"point\" and \"planes\", got the CAD form, which this version reads but "
      "does not evaluate");
}

}  // namespace tact::cli

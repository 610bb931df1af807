/// @file
/// From the CAD form of a contact relation to its contacts; notes on the models go to standard error.
#pragma once

#include "algebra/contact/contact_relation.h"
#include "robot/input/cad_relation.h"

namespace tact::cli {

/// InputError: the models or the pose do not give contacts.
algebra::ContactRelation ContactsFromCad(const input::CadRelation& relation);

}  // namespace tact::cli

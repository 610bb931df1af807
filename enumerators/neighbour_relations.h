/// @file
/// The contact relations from which an infinitesimal motion may lead to a given one.
/// Model   On the way to relation B, each of B's contacts is open or kept; a singular one, where several planes meet in an
///         edge or a vertex, may also have been a contact on one of its planes alone. So all of A's touching pairs of
///         closed elements touch in B: Donald's condition [thesis, 2.7.4]. Whether two solids and a motion
///         realise the step is another question.
#pragma once

#include <functional>

#include "algebra/contact/contact_relation.h"

namespace tact::enumerators {

/// Visits every such relation once, B itself not among them, in a fixed order; the reference is valid during the call.
void ForEachRelationBefore(const algebra::ContactRelation& relation,
                           const std::function<void(const algebra::ContactRelation&)>& visit);

}  // namespace tact::enumerators

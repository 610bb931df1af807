/// @file
/// Drawings of an abstract contact relation as the two solids that realise it.
/// Model   The moving block is drawn solid. Of the cage around it only the cavity is shown: the walls that touch the
///         block are translucent, of the others there are dotted edges. Contacts as in solid_drawing.h.
#pragma once

#include <string>

#include "algebra/contact/relation_solids.h"
#include "provers/report/projection.h"

namespace tact::provers {

/// One <svg> element without caption, for Figure. PreconditionError: a useless view.
std::string DrawRelationSolids(const algebra::RelationSolids& solids, const View& view = {});

}  // namespace tact::provers

/// @file
/// The page about the DOF classes of a census: how many there are by which definition, what excludes the others, and for
/// each of the finest classes a smallest witness with two real solids that touch so.
#pragma once

#include <string>
#include <vector>

#include "enumerators/dof_class_list.h"

namespace tact::provers {

/// Precondition: lists as enumerators::ListDofClasses returns them for the census.
std::string DofClassPage(const enumerators::DofCensus& census,
                         const std::vector<enumerators::DofClassList>& lists);

}  // namespace tact::provers

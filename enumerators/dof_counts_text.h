/// @file
/// A census' counts as text, for the units of a run (run_folder.h), and what tells one census from another.
/// Model   A JSON list, a class a line by increasing DOFs: {"values":[ten indices],"count":N,"witness":[contact numbers]}; the
///         ten are those of the last of DofDefinitions(), from which the others follow.
#pragma once

#include <string>
#include <string_view>

#include "enumerators/dof_census.h"

namespace tact::enumerators {

std::string ToText(const DofCounts& counts);
/// Reads just what ToText writes. InputError: anything else, with the place in the text.
DofCounts ParseDofCounts(std::string_view text);

/// {"kind":"dof-classes",...}: the world with a digest of its contacts, the units. Counts of equal descriptions add up.
std::string DescribeCensus(const DofCensus& census, const std::string& world, const std::string& version);

}  // namespace tact::enumerators

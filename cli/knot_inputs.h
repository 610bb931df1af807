/// @file
/// The P-data that a command's arguments name; a view that was chosen for curves is said on standard error.
/// Errors  InputError.
#pragma once

#include <vector>

#include "cli/commands.h"
#include "robot/input/knot_sequence.h"

namespace tact::cli {

/// One of each argument.
std::vector<knot::PData> ReadKnots(const KnotOptions& options);
/// The same, refused with its genus if no sphere holds one.
std::vector<knot::PData> ReadPlanarKnots(const KnotOptions& options);
/// All that the arguments hold, in order; on a sphere.
std::vector<knot::PData> ReadPlanarKnotSequence(const KnotOptions& options);

}  // namespace tact::cli

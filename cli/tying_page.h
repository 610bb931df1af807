/// @file
/// A folder that shows how a knot is tied.
/// Folder  index.html: a step after the other; steps.json: the answer of `tact knot tie --json`.
/// Errors  InputError: the folder cannot be written.
#pragma once

#include <string>

#include "algebra/knot/tying.h"

namespace tact::cli {

/// name: of the knot, for the title.
void WriteTyingFolder(const knot::Tying& tying, const std::string& name, const std::string& folder);

}  // namespace tact::cli

/// @file
/// Reads the arguments of `tact knot ...`.
#pragma once

#include <functional>

#include "cli/commands.h"

namespace CLI {
class App;
}

namespace tact::cli {

/// Adds the command; parsing its arguments sets run.
void AddKnotCommand(CLI::App& app, std::function<ExitStatus()>& run);

}  // namespace tact::cli

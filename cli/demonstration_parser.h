/// @file
/// The arguments of `tact demonstration`.
#pragma once

#include <functional>

#include "cli/commands.h"

namespace CLI {
class App;
}

namespace tact::cli {

/// Adds the command; parsing sets run.
void AddDemonstrationCommand(CLI::App& app, std::function<ExitStatus()>& run);

}  // namespace tact::cli

/// @file
/// The arguments of `tact recognize`.
#pragma once

#include <functional>

#include "cli/commands.h"

namespace CLI {
class App;
}

namespace tact::cli {

void AddRecognizeCommand(CLI::App& app, std::function<ExitStatus()>& run);

}  // namespace tact::cli

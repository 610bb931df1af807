/// @file
/// The commands of `tact`, one a file; main.cc reads their arguments and catches their errors.
/// Errors  InputError for bad input and for output that cannot be written.
#pragma once

#include <string>

namespace tact::cli {

/// Exit statuses.
enum ExitStatus : int { kAnswered = 0, kUndecided = 1, kBadInput = 2, kOurBug = 3 };

struct FileOptions {
  std::string file;   // "-" is standard input
  bool json = false;  // one JSON object a line
};

/// Motion DOFs of each contact relation of a file.
ExitStatus RunDof(const FileOptions& options);
/// Contact modes of each contact relation of a file.
ExitStatus RunModes(const FileOptions& options);

}  // namespace tact::cli

/// @file
/// `tact recognize` of recordings, whose poses carry a tracker's errors.
#pragma once

#include "cli/commands.h"

namespace tact::cli {

/// A pose list, logs an object, or anything with --noisy or --noise.
bool IsRecording(const RecognizeOptions& options);
ExitStatus RunRecognizeRecording(const RecognizeOptions& options);

}  // namespace tact::cli

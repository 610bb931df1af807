// Any bytes are a recorded demonstration, or are refused as bad input. What is read has rotations that are rotations and
// finite locations, and survives being written as JSON and read again.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "algebra/error.h"
#include "robot/input/recorded_demonstration.h"

namespace {

using namespace tact;  // NOLINT: a program of one file

void Require(bool holds) {
  if (!holds) std::abort();
}

void Check(const input::RecordedDemonstration& recording) {
  Require(!recording.scenes.empty());
  for (const input::RecordedScene& scene : recording.scenes) {
    Require((scene.X_FM.R * scene.X_FM.R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
    Require(scene.X_FM.p.allFinite());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  // Logs are files of their own: which of this machine's files a text may name is no question here.
  if (text.find("\"logs\"") != std::string::npos) return 0;
  try {
    std::istringstream in(text);
    const input::RecordedDemonstration recording = input::ReadRecording(in, "fuzz");
    Check(recording);
    std::istringstream again(input::ToDemonstrationJson(recording, "."));
    Require(input::ReadRecording(again, "again").scenes.size() == recording.scenes.size());
  } catch (const InputError& error) {
    Require(std::string(error.what()).starts_with("fuzz:"));
  }
  return 0;
}

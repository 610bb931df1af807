#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "algebra/error.h"
#include "robot/input/pose_log.h"

namespace tact::input {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(TACT_SOURCE_DIR) / "tests/robot/input/bad_logs";

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// The expected messages were read by people: place, what was expected, what was got.
TEST(BadPoseLogs, EachIsRefusedWithItsMessage) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".expected") continue;
    ++files;
    std::istringstream in(ReadText(entry.path()));
    std::string message = "accepted";
    try {
      ReadPoseLog(in, entry.path().filename());
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(message + "\n", ReadText(entry.path().string() + ".expected")) << entry.path().filename();
  }
  EXPECT_GE(files, 30U);
}

// Cut anywhere, a good log is refused as bad input or is a shorter good log.
TEST(BadPoseLogs, EveryPrefixIsAShorterLogOrRefused) {
  const std::string good =
      "# a door\n1.5 0.1 0.2 0.3 0 0 0 1\n1.6 0.1 -0.2 3e-1 0 0.6 0 0.8\n1.7 0 0 0 1 0 0 0\n";
  for (size_t length = 0; length <= good.size(); ++length) {
    std::istringstream in(good.substr(0, length));
    try {
      EXPECT_LE(ReadPoseLog(in, "cut").poses.size(), 3U);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("cut:", 0), 0U) << error.what();
    }
  }
}

}  // namespace
}  // namespace tact::input

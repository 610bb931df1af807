#include <gtest/gtest.h>

#include <sstream>

#include "robot/input/pose_log.h"
#include "tests/robot/bad_folder.h"

namespace tact::input {
namespace {

TEST(BadPoseLogs, EachIsRefusedWithItsMessage) {
  ExpectEachRefused("input/bad_logs", 30, [](const std::string& text, const std::string& name) {
    std::istringstream in(text);
    ReadPoseLog(in, name);
  });
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

#include <gtest/gtest.h>

#include <sstream>

#include "robot/input/recorded_demonstration.h"
#include "tests/robot/bad_folder.h"

namespace tact::input {
namespace {

TEST(BadRecordings, EachIsRefusedWithItsMessage) {
  ExpectEachRefused("input/bad_recordings", 30, [](const std::string& text, const std::string& name) {
    std::istringstream in(text);
    ReadRecording(in, name);
  });
}

// Its counts tell when a list was cut: every prefix without its last number is refused.
TEST(BadRecordings, EveryPrefixOfAListIsRefused) {
  const std::string good =
      "No of Models: 2\r\n.\\a.off\r\nb.off\r\n\r\nNo of Scenes: 1\r\n2 1 2 3 0 0 1 0.5\r\n0 4 5 6 0 1 0 1";
  for (size_t length = 0; length < good.size(); ++length) {
    std::istringstream in(good.substr(0, length));
    try {
      ReadRecording(in, "cut");
      ADD_FAILURE() << length;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("cut:", 0), 0U) << error.what();
    }
  }
  std::istringstream in(good);
  EXPECT_EQ(ReadRecording(in, "whole").scenes.size(), 1U);
}

}  // namespace
}  // namespace tact::input

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "algebra/error.h"
#include "robot/input/recorded_demonstration.h"

namespace tact::input {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(TACT_SOURCE_DIR) / "tests/robot/input/bad_recordings";

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// The expected messages were read by people: place, what was expected, what was got.
TEST(BadRecordings, EachIsRefusedWithItsMessage) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".expected") continue;
    ++files;
    std::istringstream in(ReadText(entry.path()));
    std::string message = "accepted";
    try {
      ReadRecording(in, entry.path().filename());
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(message + "\n", ReadText(entry.path().string() + ".expected")) << entry.path().filename();
  }
  EXPECT_GE(files, 30U);
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

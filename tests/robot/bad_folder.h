/// @file
/// Folders of bad files, each with the message that it must give, as people read it: place, what was expected, what was got.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "algebra/error.h"

namespace tact {

inline std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The folder lies below tests/robot. The message of a.txt is in a.txt.expected, or in a.expected. `read` is given a file's
/// contents and its name.
template <class Read>
void ExpectEachRefused(const std::string& folder, size_t fewest, const Read& read) {
  size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TACT_SOURCE_DIR) / "tests/robot" / folder)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".expected") continue;
    ++files;
    std::filesystem::path expected = path.string() + ".expected";
    if (!std::filesystem::exists(expected))
      expected = std::filesystem::path(path).replace_extension(".expected");
    std::string message = "accepted";
    try {
      read(ReadText(path), path.filename().string());
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(message + "\n", ReadText(expected)) << path.filename();
  }
  EXPECT_GE(files, fewest);
}

}  // namespace tact

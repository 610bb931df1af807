#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "robot/input/demonstration.h"
#include "robot/input/relation_file.h"

namespace tact::input {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(TACT_SOURCE_DIR) / "tests/robot/input/bad";

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// The first word of a file's name says what it was meant to be.
void Read(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::istringstream in(ReadText(path));
  if (name.starts_with("pose_")) {
    JsonStream documents(in, name);
    ParsePose(documents.Next()->root());
  } else if (name.starts_with("demo_")) {
    ReadDemonstration(in, name);
  } else {
    RelationStream relations(in, name);
    while (relations.Next()) continue;
  }
}

// The expected messages were written and checked by people: place, what was expected, what was got.
TEST(BadFiles, EachIsRefusedWithItsMessage) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    std::filesystem::path expected = entry.path();
    expected.replace_extension(".expected");
    std::string message = "accepted";
    try {
      Read(entry.path());
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(message + "\n", ReadText(expected)) << entry.path().filename();
  }
  EXPECT_GE(files, 80u);
}

// Cut anywhere, a good file is refused as bad input or is a shorter good file; nothing else happens.
TEST(BadFiles, EveryPrefixOfAGoodFileIsRefusedAsCut) {
  const std::string good =
      R"({"contacts":[{"point":[1.5e1,-2,"1/3"],"planes":[[0,0,1],[0,1,0]],"name":"a\u00e4\n"},)"
      "\n"
      R"({"point":[0,0,0],"planes":[[1,0,0]]}]})";
  for (size_t length = 0; length < good.size(); ++length) {
    std::istringstream in(good.substr(0, length));
    RelationStream relations(in, "cut.json");
    try {
      relations.Next();
      ADD_FAILURE() << "accepted at length " << length;
    } catch (const InputError& error) {
      const std::string message = error.what();
      const bool says_cut = message.find("the end of the text") != std::string::npos ||
                            message.find("an empty file") != std::string::npos;
      EXPECT_TRUE(says_cut) << length << ": " << message;
    }
  }
}

}  // namespace
}  // namespace tact::input

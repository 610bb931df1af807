#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "robot/input/demonstration.h"
#include "robot/input/relation_file.h"
#include "tests/robot/bad_folder.h"

namespace tact::input {
namespace {

// The first word of a file's name says what it was meant to be.
void Read(const std::string& text, const std::string& name) {
  std::istringstream in(text);
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

TEST(BadFiles, EachIsRefusedWithItsMessage) { ExpectEachRefused("input/bad", 80, Read); }

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

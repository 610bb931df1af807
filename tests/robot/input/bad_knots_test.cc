#include <gtest/gtest.h>

#include <sstream>

#include "robot/input/knot_move_text.h"
#include "robot/input/knot_text.h"
#include "tests/robot/bad_folder.h"

namespace tact::input {
namespace {

// The first word of a file's name says what it was meant to be.
void Read(const std::string& text, const std::string& name) {
  if (name.starts_with("move_")) {
    ParseMove(text, name);
  } else {
    ParsePData(text, name);
  }
}

TEST(BadKnots, EachIsRefusedWithItsMessage) { ExpectEachRefused("input/bad_knots", 65, Read); }

// Cut anywhere, good texts are refused as bad input or are shorter good ones; nothing else happens.
TEST(BadKnots, EveryPrefixOfAGoodTextIsRefusedOrGood) {
  for (const std::string good :
       {R"({"sigma":[4,5,6,1,2,3],"attr":[3,4,3,4,3,4],"name":"a"})", "1 2 3 4 / 3 4 1 2 / 1 2 2 1",
        "O1+ U2+ O3+ U1+ O2+ U3+", "1 -2 3 -1 2 -3 / + + +", "PD[X[3,1,4,0],X[1,5,2,4],X[5,3,6,2]];",
        R"({"kind":"R1","direction":"add","segments":[2],"attr":3})"}) {
    for (size_t length = 0; length <= good.size(); ++length) {
      for (const bool move : {false, true}) {
        try {
          if (move) {
            ParseMove(good.substr(0, length), "cut");
          } else {
            ParsePData(good.substr(0, length), "cut");
          }
        } catch (const InputError& error) {
          EXPECT_TRUE(std::string(error.what()).starts_with("cut:1:")) << error.what();
        }
      }
    }
  }
}

}  // namespace
}  // namespace tact::input

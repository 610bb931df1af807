#include "robot/input/knot_move_text.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::input {
namespace {

std::string Refusal(const std::string& text) {
  try {
    return "accepted: " + MoveToJson(ParseMove(text, "move"));
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(KnotMoveText, EveryMoveReadsBack) {
  std::mt19937_64 random(17);
  for (int crossings = 0; crossings <= 8; ++crossings) {
    for (const knot::Move& move : AllMoves(knot::RandomPData(random, crossings))) {
      for (const bool swapped : {false, true}) {
        const knot::Explanation explanation{move, swapped};
        ASSERT_EQ(ParseMove(MoveToJson(explanation), "move"), explanation) << MoveToJson(explanation);
      }
    }
  }
}

TEST(KnotMoveText, KeysAsTheDesignOfTheCommandFixesThem) {
  using knot::MoveDirection;
  using knot::MoveKind;
  EXPECT_EQ(
      MoveToJson({{MoveKind::kR2, MoveDirection::kRemove, {2, 5, 0}, {}, 1, true}, false}),
      R"({"kind":"R2","direction":"remove","segments":[2,5],"end":null,"selective_end":"same","attr":1,)"
      R"("order":"opposite"})");
  EXPECT_EQ(
      MoveToJson({{MoveKind::kCross, MoveDirection::kAdd, {3, 0, 0}, knot::RopeEnd::kOther, 4}, true}),
      R"({"kind":"Cross","direction":"add","segments":[3],"end":"other","selective_end":"swapped","attr":4,)"
      R"("order":null})");
  EXPECT_EQ(
      MoveToJson({{MoveKind::kR3, MoveDirection::kShift, {2, 6, 4}}, false}),
      R"({"kind":"R3","direction":"shift","segments":[2,6,4],"end":null,"selective_end":"same","attr":null,)"
      R"("order":null})");
}

TEST(KnotMoveText, NullsMayBeLeftOut) {
  EXPECT_EQ(ParseMove(R"({"kind":"R1","direction":"add","segments":[2],"attr":3})", "move"),
            ParseMove(R"({"attr":3,"segments":[2],"end":null,"order":null,"kind":"R1","direction":"add"})",
                      "move"));
}

TEST(KnotMoveText, WhatIsWrongIsNamed) {
  EXPECT_EQ(Refusal(R"({"kind":"R4","direction":"add","segments":[2],"attr":3})"),
            R"(move:1:9: expected "R1", "R2", "R3" or "Cross", got "R4")");
  EXPECT_EQ(
      Refusal(R"({"kind":"R1","direction":"add","segments":[2],"attr":3,"speed":1})"),
      R"(move:1:56: expected one of the keys "kind", "direction", "segments", "end", "selective_end", "attr" and )"
      R"("order", got "speed")");
  EXPECT_EQ(Refusal(R"({"kind":"R1","direction":"add","segments":[2,3],"attr":3})"),
            "move:1:43: expected one segment of R1, got an array of 2 values");
  EXPECT_EQ(Refusal(R"({"kind":"R3","direction":"add","segments":[2,3,4]})"),
            R"(move:1:26: expected "shift" as the direction of R3, got the string "add")");
  EXPECT_EQ(
      Refusal(R"({"kind":"Cross","direction":"add","segments":[2],"attr":3})"),
      R"(move:1:1: expected the key "end", got an object with only "kind", "direction", "segments" and "attr")");
  EXPECT_EQ(Refusal(R"({"kind":"R1","direction":"add","segments":[2],"attr":3,"end":"other"})"),
            R"(move:1:62: expected null as the end of R1, got the string "other")");
  EXPECT_EQ(
      Refusal(R"({"kind":"R2","direction":"add","segments":[2,3],"attr":3})"),
      R"(move:1:1: expected the key "order", got an object with only "kind", "direction", "segments" and "attr")");
  EXPECT_EQ(Refusal(R"({"kind":"R1","direction":"add","segments":[0],"attr":3})"),
            "move:1:44: expected an integer from 1 to 33554432, got the number 0");
  EXPECT_EQ(Refusal(R"({"kind":"R1","direction":"add","segments":[1],"attr":5})"),
            "move:1:54: expected an integer from 1 to 4, got the number 5");
  EXPECT_EQ(Refusal("[]").substr(0, 39), "move:1:1: expected an object with the k");
}

}  // namespace
}  // namespace tact::input

#include "robot/input/json_value.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tact::input {
namespace {

using algebra::Rational;

JsonDocument Parse(const std::string& text) { return JsonDocument::Parse(text, "t"); }

TEST(JsonValue, NumbersAreTheDecimalTheyWrite) {
  const auto document = Parse(R"([0.1, -52.4999999999999, 1e3, "22/7", 123456789012345678901234567890, -0])");
  std::vector<Rational> read;
  for (const JsonValue value : document.root().Elements("numbers")) read.push_back(value.ReadRational());
  EXPECT_EQ(read,
            (std::vector<Rational>{Rational(1, 10), *Rational::Parse("-524999999999999/10000000000000"), 1000,
                                   Rational(22, 7), *Rational::Parse("123456789012345678901234567890"), 0}));
}

TEST(JsonValue, EscapesAreReadAndKeysComparedAsRead) {
  const auto document = Parse(R"({"n\u0061me":"\"\\\/\b\f\n\r\t\u00e4\ud83d\ude00","b":"\\"})");
  EXPECT_EQ(document.root().At("name").ReadString("text"), "\"\\/\b\f\n\r\t\u00e4\U0001F600");
  EXPECT_EQ(document.root().At("b").ReadString("text"), "\\");
}

TEST(JsonValue, EveryKindOfTokenKnowsItsPlace) {
  const auto document = Parse("[1,\n \"a\\\"b\", [ ],\r\n{\"k\" :true}, 2.5e1 ,null]");
  std::vector<std::string> places;
  for (const JsonValue value : document.root().Elements("values")) places.push_back(value.Where());
  EXPECT_EQ(places, (std::vector<std::string>{"t:1:2", "t:2:2", "t:2:10", "t:3:1", "t:3:14", "t:3:21"}));
  std::vector<JsonValue> values;
  for (const JsonValue value : document.root().Elements("values")) values.push_back(value);
  EXPECT_EQ(values[3].At("k").Where(), "t:3:7");
}

TEST(JsonValue, AByteOrderMarkIsNoPartOfTheValue) { EXPECT_EQ(Parse("\xEF\xBB\xBF[7]").root().size(), 1u); }

TEST(JsonValue, IntegersAreBounded) {
  const auto document = Parse(R"([5, 5.0, 5.5, 6, -1, "5", 1e30])");
  std::vector<JsonValue> values;
  for (const JsonValue value : document.root().Elements("numbers")) values.push_back(value);
  EXPECT_EQ(values[0].ReadInteger(0, 5), 5);
  EXPECT_EQ(values[1].ReadInteger(0, 5), 5);
  for (size_t i = 2; i < values.size(); ++i) EXPECT_THROW(values[i].ReadInteger(0, 5), InputError) << i;
}

TEST(JsonValue, ManyKeysAreComparedWithoutQuadraticTime) {
  std::string text = "{";
  for (int i = 0; i < 200000; ++i) text += "\"k" + std::to_string(i) + "\":0,";
  EXPECT_EQ(Parse(text + "\"z\":0}").root().size(), 200001u);
  EXPECT_THROW(Parse(text + "\"k7\":0}"), InputError);
}

// A random tree of values, as text; an object has the keys k0, k1, ...
std::string RandomText(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 5 : 3);
  if (kind == 0) return std::to_string(*rc::gen::arbitrary<int>());
  if (kind == 1)
    return *rc::gen::elementOf(std::vector<std::string>{"1.5", "-0.25e2", "true", "false", "null"});
  if (kind == 2)
    return *rc::gen::elementOf(std::vector<std::string>{R"("")", R"("a b")", R"("\\\"")", R"("ä,]}")"});
  const int count = *rc::gen::inRange(0, 4);
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += *rc::gen::elementOf(std::vector<std::string>{",", " , ", ",\n"});
    if (kind == 4) text += "\"k" + std::to_string(i) + "\": ";
    text += RandomText(depth - 1);
  }
  return kind == 3 ? "[" + text + "]" : "{" + text + "}";
}

std::string Print(const JsonValue& value) {
  switch (value.kind()) {
    case JsonKind::kNull:
      return "null";
    case JsonKind::kTrue:
      return "true";
    case JsonKind::kFalse:
      return "false";
    case JsonKind::kNumber:
      return value.ReadRational().ToString();
    case JsonKind::kString:
      return "\"" + value.ReadString("text") + "\"";
    case JsonKind::kArray: {
      std::string text = "[";
      for (const JsonValue element : value.Elements("values")) text += Print(element) + ",";
      return text + "]";
    }
    case JsonKind::kObject: {
      std::string text = "{";
      for (size_t i = 0; i < value.size(); ++i) {
        text += Print(value.At("k" + std::to_string(i))) + ",";
      }
      return text + "}";
    }
  }
  return "";
}

// Blanks around a text move its place and nothing else; an element reads as it does alone.
RC_GTEST_PROP(JsonLaw, BlanksMoveAValueAndChangeNothingElse, ()) {
  const std::string text = "[" + RandomText(3) + "]";
  const JsonDocument plain = Parse(text);
  const JsonDocument padded = Parse("\n\n  " + text + " \r\n");
  RC_ASSERT(Print(plain.root()) == Print(padded.root()));
  RC_ASSERT(plain.root().Where() == "t:1:1");
  RC_ASSERT(padded.root().Where() == "t:3:3");
  const JsonDocument inner = Parse(text.substr(1, text.size() - 2));
  for (const JsonValue element : plain.root().Elements("values")) {
    RC_ASSERT(Print(inner.root()) == Print(element));
  }
}

}  // namespace
}  // namespace tact::input

#include "provers/check/json_value.h"

#include <gtest/gtest.h>

namespace tact::check {
namespace {

std::string WhyRefused(const std::string& text) {
  try {
    ParseJson(text);
  } catch (const Refused& refused) {
    return refused.what();
  }
  return "";
}

bool IsInteger(const std::string& text) {
  const Value value = ParseJson(text);
  try {
    AsInteger(value);
    return true;
  } catch (const Refused&) {
    return false;
  }
}

TEST(JsonValue, IntegersAreReadExactlyAtTheEdgeOfDoubles) {
  EXPECT_EQ(AsInteger(ParseJson("9007199254740992")).get_str(), "9007199254740992");
  EXPECT_EQ(AsInteger(ParseJson("-9007199254740992")).get_str(), "-9007199254740992");
  EXPECT_EQ(AsInteger(ParseJson("\"9007199254740993\"")).get_str(), "9007199254740993");
  EXPECT_EQ(AsInteger(ParseJson("\"-12\"")).get_str(), "-12");
}

TEST(JsonValue, NumbersThatAReaderMightRoundAreNoIntegers) {
  for (const char* text :
       {"9007199254740993", "-9007199254740993", "18446744073709551615", "18446744073709551616", "1e3", "1.0",
        "0.5", "-0.0", "1e-2", "12345678901234567890123"}) {
    EXPECT_FALSE(IsInteger(text)) << text;
  }
}

TEST(JsonValue, StringsThatAreNotPlainDigitsAreNoIntegers) {
  for (const char* text :
       {"\"\"", "\"-\"", "\"+1\"", "\"01\"", "\"-0\"", "\"00\"", "\"1 \"", "\" 1\"", "\"0x10\"", "\"1/2\"",
        "\"1\\u0000\"", "\"\xd9\xa1\"", "true", "null", "[1]", "{}"}) {
    EXPECT_FALSE(IsInteger(text)) << text;
  }
}

TEST(JsonValue, AHundredThousandDigitsAreReadAndOneMoreIsRefused) {
  EXPECT_TRUE(IsInteger("\"" + std::string(kMaxDigits, '7') + "\""));
  EXPECT_FALSE(IsInteger("\"" + std::string(kMaxDigits + 1, '7') + "\""));
}

TEST(JsonValue, ANumberOfManyDigitsWithoutQuotationMarksIsRefusedBriefly) {
  const std::string why = WhyRefused(std::string(1000000, '9'));
  EXPECT_FALSE(why.empty());
  EXPECT_LT(why.size(), 300u);
}

TEST(JsonValue, AKeyTwiceInOneObjectIsRefused) {
  EXPECT_EQ(WhyRefused(R"({"a":1,"b":2,"a":1})"), "the key \"a\" stands twice in one object");
  EXPECT_EQ(WhyRefused(R"({"a":{"a":1},"b":{"a":1}})"), "");
}

TEST(JsonValue, DeepNestingIsRefusedWithoutRecursion) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(WhyRefused(nested(kMaxDepth)), "");
  EXPECT_EQ(WhyRefused(nested(kMaxDepth + 1)), "nested deeper than 32 levels");
  EXPECT_EQ(WhyRefused(std::string(10000000, '[')), "nested deeper than 32 levels");
}

TEST(JsonValue, WhatIsNoJsonIsRefused) {
  for (const std::string& text :
       {std::string(), std::string(" "), std::string("{"), std::string("[1,]"), std::string("[1] 2"),
        std::string("// 1\n2"), std::string("\"\xff\""), std::string("1\0", 2), std::string("NaN"),
        std::string("[1e999]"), std::string("'a'")}) {
    EXPECT_FALSE(WhyRefused(text).empty()) << text;
  }
}

TEST(JsonValue, ALongerTextThanTheLimitIsRefused) {
  EXPECT_EQ(WhyRefused(std::string(kMaxBytes + 1, ' ')), "longer than 67108864 bytes");
}

TEST(JsonValue, AReasonNeverPrintsControlCharacters) {
  for (const std::string& why :
       {WhyRefused("\"\x01\x1b[31m"), WhyRefused("{\"\\u001b\":1,\"\\u001b\":2}"), WhyRefused("\"\xff")}) {
    for (char c : why) EXPECT_TRUE(c >= ' ' && c <= '~') << why;
  }
  const Value root = ParseJson("{\"\\u001b[31m\":{\"b\":[0,1]}}");
  EXPECT_EQ(PathOf(root, &AsArray(At(AsObject(root)[0].value, "b"))[1]), "\"\\u001b[31m\".b[1]");
}

}  // namespace
}  // namespace tact::check

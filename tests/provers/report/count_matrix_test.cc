#include "provers/report/count_matrix.h"

#include <gtest/gtest.h>

#include <regex>

#include "algebra/error.h"

namespace tact::provers {
namespace {

size_t Occurrences(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

const std::vector<std::string> kNames = {"a", "b", "c<"};
const std::vector<std::vector<uint64_t>> kCounts = {{7, 1, 0}, {20, 7, 12345}, {0, 3, 7}};
const std::vector<std::vector<bool>> kMarked = {
    {false, false, true}, {false, false, false}, {true, false, false}};

TEST(CountMatrix, ShowsEveryCountOnceAndNotTheDiagonal) {
  const std::string svg = DrawCountMatrix(kNames, {{"here", kCounts}}, kMarked, "marked");
  for (const char* number : {">1<", ">20<", ">3<"}) EXPECT_EQ(Occurrences(svg, number), 1U) << number;
  EXPECT_EQ(Occurrences(svg, ">7<"), 0U);
  EXPECT_EQ(Occurrences(svg, ">0<"), 0U);  // hatched instead
}

// Two cells are marked in each panel, and the legend shows the mark.
TEST(CountMatrix, MarksCellsInEveryPanel) {
  const std::string svg = DrawCountMatrix(kNames, {{"here", kCounts}, {"there", kCounts}}, kMarked, "marked");
  EXPECT_EQ(Occurrences(svg, "#b5127a"), 2U * 2 + 1);
  EXPECT_EQ(Occurrences(svg, ">here<"), 1U);
  EXPECT_EQ(Occurrences(svg, ">there<"), 1U);
}

TEST(CountMatrix, IsOneEscapedElement) {
  const std::string svg = DrawCountMatrix(kNames, {{"a & b", kCounts}}, kMarked, "x < y");
  EXPECT_EQ(Occurrences(svg, "<svg"), 1U);
  EXPECT_TRUE(svg.ends_with("</svg>"));
  EXPECT_EQ(Occurrences(svg, "c&lt;"), 2U);
  EXPECT_EQ(Occurrences(svg, ">a &amp; b<"), 1U);
  EXPECT_FALSE(std::regex_search(svg, std::regex("nan|inf|&(?!(amp|lt|gt|quot|#39|apos);)")));
}

TEST(CountMatrix, MoreIsDarker) {
  const auto fill_before = [](const std::string& svg, const std::string& number) {
    const size_t at = svg.find(number);
    const size_t fill = svg.find("fill=\"#", svg.rfind("<rect", at));
    int sum = 0;
    for (size_t i = 0; i < 3; ++i) sum += std::stoi(svg.substr(fill + 7 + 2 * i, 2), nullptr, 16);
    return sum;
  };
  const std::string svg =
      DrawCountMatrix({"a", "b"}, {{"", {{0, 2}, {900, 0}}}}, {{false, false}, {false, false}}, "");
  EXPECT_LT(fill_before(svg, ">900<"), fill_before(svg, ">2<"));
}

TEST(CountMatrix, OtherShapesAreRefused) {
  EXPECT_THROW(DrawCountMatrix({"a"}, {{"", kCounts}}, {{false}}, ""), PreconditionError);
  EXPECT_THROW(DrawCountMatrix(kNames, {{"", kCounts}}, {{false}}, ""), PreconditionError);
}

}  // namespace
}  // namespace tact::provers

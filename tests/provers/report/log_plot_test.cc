#include "provers/report/log_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "algebra/error.h"

namespace tact::provers {
namespace {

LogPlot Example() {
  return {"errors",
          "poses",
          "degrees",
          {50, 100, 200},
          {{"45", {4, 2, 1}, {4, 2.5, 1}}, {"90", {0.4, 0.2, 0.1}, {}}}};
}

TEST(LogPlot, IsOneSvgWithALineASeriesAndARingAPrintedValue) {
  const std::string svg = DrawLogPlot(Example());
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_TRUE(svg.ends_with("</svg>"));
  const std::regex lines("stroke-width=\"1.6\" fill=\"none\"/>"), rings("<circle");
  EXPECT_EQ(std::distance(std::sregex_iterator(svg.begin(), svg.end(), lines), {}), 2);
  EXPECT_EQ(std::distance(std::sregex_iterator(svg.begin(), svg.end(), rings), {}), 3);
}

// A power law is a straight line: equal steps down for equal factors.
TEST(LogPlot, APowerLawIsAStraightLine) {
  const std::string svg = DrawLogPlot(Example());
  std::smatch m;
  const std::regex path("M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\"");
  ASSERT_TRUE(std::regex_search(svg, m, path));
  const auto at = [&](int k) { return std::stod(m[k]); };
  EXPECT_NEAR(at(5) - at(3), at(3) - at(1), 0.02);
  EXPECT_NEAR(at(6) - at(4), at(4) - at(2), 0.02);
  EXPECT_GT(at(4), at(2));  // smaller is lower
}

TEST(LogPlot, WhatHasNoLogarithmOrAnotherLengthIsRefused) {
  LogPlot plot = Example();
  plot.series[0].values[1] = 0;
  EXPECT_THROW(DrawLogPlot(plot), PreconditionError);
  plot = Example();
  plot.series[1].printed = {1};
  EXPECT_THROW(DrawLogPlot(plot), PreconditionError);
}

}  // namespace
}  // namespace tact::provers

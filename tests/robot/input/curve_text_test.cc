#include "robot/input/curve_text.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "robot/input/knot_text.h"

namespace tact::input {
namespace {

using algebra::Rational;
using algebra::Vector3;

std::vector<CurveText> Parse(std::string_view text) { return ParseCurves({text, "text", 1}); }
bool Looks(std::string_view text, const std::string& source = "text") {
  return LooksLikeCurve({text, source, 1});
}

TEST(CurveText, NumbersAreWhatTheyWrite) {
  const auto curves = Parse("# a rope\n\n0.1 -2e-3 1/3\n  1,2;3 # its other end\r\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].points,
            (knot::Curve{{Rational(1, 10), Rational(-1, 500), Rational(1, 3)}, Vector3{1, 2, 3}}));
  EXPECT_EQ(curves[0].offsets, (std::vector<size_t>{10, 26}));
}

TEST(CurveText, DashesSetStepsApart) {
  const auto curves = Parse("0 0 0\n1 0 0\n---\n0 0 0 # --- is no step here\n0 1 0\n-----\n5 5 5\n");
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[1].points, (knot::Curve{{0, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(curves[2].points, (knot::Curve{{5, 5, 5}}));
}

TEST(CurveText, IsToldFromOtherNotations) {
  EXPECT_TRUE(Looks("0 0 0\n1 0 0\n"));
  EXPECT_TRUE(Looks("# comment\n\n0,0,0"));
  EXPECT_TRUE(Looks("nan 0 0"));
  EXPECT_TRUE(Looks("anything at all", "rope.xyz"));
  for (const char* other : {"1 -1 +", "2 1 / 3 4", "1 2\n2 1\n3 4\n", "O1+ U1+", "/", "", R"({"sigma":[]})",
                            "PD[X[1,1,2,0]]", "1 -2 3 -1 2 -3 +++"}) {
    EXPECT_FALSE(Looks(other)) << other;
  }
}

TEST(CurveText, IsPDataSeenFromAbove) {
  // A loop led over itself: up along y, back along x over the first edge; (1,0) x (0,1) is positive.
  EXPECT_EQ(ParsePData("0 -2 0\n0 2 0\n-2 2 1\n-2 0 1\n2 0 1\n", "loop"), knot::PData({2, 1}, {4, 3}));
}

TEST(CurveText, ViewsAreDirectionsOrAuto) {
  EXPECT_EQ(ParseView("auto", "--view"), std::nullopt);
  EXPECT_EQ(ParseView("0.5,-1/3,2", "--view"), (Vector3{Rational(1, 2), Rational(-1, 3), 2}));
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      ParseView(text, "--view");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const std::string text : {"", "1,2", "1,2,3,4", "1,2,x", "1 2 3", ",1,2,3", "nan,0,0"})
    EXPECT_EQ(refusal(text), "--view: expected X,Y,Z or auto, got \"" + text + "\"");
  EXPECT_EQ(refusal("0,0,0"), "--view: expected a direction that is not zero, got \"0,0,0\"");
}

}  // namespace
}  // namespace tact::input

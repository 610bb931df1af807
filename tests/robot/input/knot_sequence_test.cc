#include "robot/input/knot_sequence.h"

#include <gtest/gtest.h>

#include "algebra/error.h"

namespace tact::input {
namespace {

using algebra::Vector3;

const CurveView kAbove = knot::ViewFromAbove();
const std::string kLoop = "0 -2 0\n0 2 0\n-2 2 1\n-2 0 1\n2 0 1\n";
const knot::PData kLoopRead({2, 1}, {4, 3});

TEST(KnotSequence, TextsAndCurvesInTheirOrder) {
  const KnotSequence sequence =
      ReadKnotSequence({"2 1 / 3 4", kLoop + "---\n0 0 0\n1 0 0\n",
                        "{\"sigma\":[],\"attr\":[]}\n\n{\"sigma\":[2,1],\"attr\":[1,2]}\n", "O1+ U1+"},
                       kAbove);
  ASSERT_EQ(sequence.knots.size(), 6U);
  const std::vector<knot::PData> expected = {
      knot::PData({2, 1}, {3, 4}), kLoopRead, {}, {}, knot::PData({2, 1}, {1, 2}),
      knot::PData({2, 1}, {3, 4})};
  const std::vector<size_t> arguments = {0, 1, 1, 2, 2, 3};
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(sequence.knots[i].p, expected[i]) << i;
    EXPECT_EQ(sequence.knots[i].argument, arguments[i]) << i;
  }
  EXPECT_EQ(sequence.knots[4].place, "<argument>:3:1");
  EXPECT_FALSE(sequence.chosen);
}

TEST(KnotSequence, AnObjectMayTakeManyLines) {
  const KnotSequence sequence = ReadKnotSequence({"{\"sigma\":[2,1],\n\"attr\":[3,4]}"}, kAbove);
  ASSERT_EQ(sequence.knots.size(), 1U);
  EXPECT_EQ(sequence.knots[0].p, knot::PData({2, 1}, {3, 4}));
}

// A loop that stands upright: an edge is vertical from above.
TEST(KnotSequence, CurvesOfAllArgumentsHaveOneView) {
  const std::string upright = "0 0 0\n0 0 9\n6 1 9\n6 0 4\n-4 1 3\n";
  const KnotSequence sequence = ReadKnotSequence({kLoop, upright}, std::nullopt);
  ASSERT_TRUE(sequence.chosen);
  EXPECT_NE(sequence.chosen->view, knot::ViewFromAbove());
  const auto again = ReadKnotSequence({kLoop, upright}, CurveView(sequence.chosen->view));
  EXPECT_EQ(again.knots[0].p, sequence.knots[0].p);
  EXPECT_EQ(again.knots[1].p, sequence.knots[1].p);
}

TEST(KnotSequence, AFaultIsSaidAtItsPointWithTheView) {
  const auto refusal = [](const std::string& text, const CurveView& view) -> std::string {
    try {
      ReadKnotSequence({"0 0 0\n1 0 0\n", text}, view);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(
      refusal("0 0 0\n2 0 0\n2 0 3\n", CurveView(Vector3{0, 0, 2})),
      "<argument>:3:1: expected edges that are seen as lines, got one along the view: that of points 2 and "
      "3; so it is seen from (0, 0, 2), --view auto tries others");
  EXPECT_EQ(refusal("0 0 0\n2 0 0\n2 0 3\n", std::nullopt), "accepted");
  EXPECT_EQ(
      refusal("0 0 0\n2 0 0\n1 0 0\n", std::nullopt),
      "<argument>:3:1: expected a rope that does not meet itself, got two edges with a point in common: that "
      "of points 1 and 2, that of points 2 and 3");
}

}  // namespace
}  // namespace tact::input

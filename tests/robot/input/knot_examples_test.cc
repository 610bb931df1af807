#include "robot/input/knot_examples.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "algebra/knot/closure.h"
#include "robot/input/curve_text.h"
#include "robot/input/knot_text.h"
#include "tests/algebra/knot/slow_projection.h"

namespace tact::input {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(TACT_SOURCE_DIR) / "examples/knots";

TEST(KnotExamples, TheProgramHoldsTheFiles) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".xyz") continue;
    ++files;
    const auto example = FindKnotExample(entry.path().stem().string());
    ASSERT_TRUE(example) << entry.path();
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    EXPECT_EQ(example->text, text.str());
    EXPECT_EQ(example->source, "examples/knots/" + entry.path().filename().string());
  }
  EXPECT_EQ(files, KnotExamples().size());
  EXPECT_FALSE(FindKnotExample("granny"));
}

// Counted in drawings of the curves: how often each rope crosses itself.
const std::map<std::string, int> kIntersections = {
    {"overhand", 3},         {"figure_eight", 4},    {"bowline", 7},  {"harness_hitch", 7},
    {"two_half_hitches", 6}, {"taut_line_hitch", 8}, {"bow_tie", 10}, {"single_loop_bow", 8}};

TEST(KnotExamples, EightKnotsHaveTheIntersectionsOfTheirDrawings) {
  for (const auto& [name, intersections] : kIntersections)
    EXPECT_EQ(ReadPData(name).crossings(), intersections) << name;
}

// [thesis, 5.4.1].
TEST(KnotExamples, TheOverhandKnotIsThatOfTheThesis) {
  EXPECT_EQ(ReadPData("overhand"), knot::PData({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4}));
}

TEST(KnotExamples, TheSlowWayReadsEveryCurveTheSame) {
  for (const KnotExample& example : KnotExamples()) {
    for (const CurveText& curve : ParseCurves({example.text, example.source, 1})) {
      const auto projection =
          std::get<knot::CurveProjection>(knot::ProjectCurve(curve.points, knot::ViewFromAbove()));
      EXPECT_EQ(projection.p, knot::ProjectSlowly(curve.points, {}).p) << example.name;
    }
  }
}

// The rope's ends can be joined without crossing it, but for the bowline, whose free end lies within its loop.
TEST(KnotExamples, EndsLieOnOneFaceButTheBowlines) {
  for (const auto& [name, intersections] : kIntersections)
    EXPECT_EQ(knot::EndsOnOneFace(ReadPData(name)), name != "bowline") << name;
}

}  // namespace
}  // namespace tact::input

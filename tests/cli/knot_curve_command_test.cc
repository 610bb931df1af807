#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

const std::string kKnots = std::string(TACT_SOURCE_DIR) + "/examples/knots/";

std::string ReadText(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Answer Recognize(const std::string& knot) { return RunTact({"knot", "recognize", knot}); }

// How many lines begin with that.
int CountLines(const std::string& text, const std::string& start) {
  int count = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) count += line.starts_with(start) ? 1 : 0;
  return count;
}

TEST(KnotCurveCommand, AnExampleByNameByFileAndOnStandardInputIsTheSame) {
  const Answer by_name = RunTact({"knot", "check", "bowline"});
  EXPECT_EQ(by_name.status, 0) << by_name.err;
  EXPECT_EQ(RunTact({"knot", "check", kKnots + "bowline.xyz"}).out, by_name.out);
  EXPECT_EQ(RunTact({"knot", "check", "-"}, ReadText(kKnots + "bowline.xyz")).out, by_name.out);
}

TEST(KnotCurveCommand, EveryCommandTakesCurves) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"convert", "overhand", "--to", "gauss"},
           {"check", "overhand"},
           {"faces", "overhand"},
           {"moves", "overhand", "figure_eight"},
           {"apply", "/", R"({"kind":"R1","direction":"add","segments":[1],"attr":3})"},
           {"recognize", "overhand", "figure_eight"},
           {"tie", "overhand"}}) {
    std::vector<std::string> words = {"knot"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Answer answer = RunTact(words);
    EXPECT_EQ(answer.status, 0) << arguments[0] << ": " << answer.err;
  }
  // [thesis, 5.4.1], as a signed Gauss code.
  EXPECT_EQ(RunTact({"knot", "convert", "overhand", "--to", "gauss"}).out, "O1+ U2+ O3+ U1+ O2+ U3+\n");
}

// The fewest moves that each knot of the examples takes; a search that knows no knot by name proves them shortest.
TEST(KnotCurveCommand, TheEightKnotsAreTied) {
  const std::map<std::string, int> steps = {
      {"overhand", 3},         {"figure_eight", 3},    {"bowline", 5}, {"harness_hitch", 4},
      {"two_half_hitches", 6}, {"taut_line_hitch", 8}, {"bow_tie", 7}, {"single_loop_bow", 6}};
  for (const auto& [name, count] : steps) {
    const Answer answer = RunTact({"knot", "tie", name});
    EXPECT_EQ(answer.status, 0) << name;
    EXPECT_NE(answer.out.find("\n" + std::to_string(count) + " steps, proved shortest.\n"), std::string::npos)
        << name << answer.out;
  }
}

// It is a loop tied in the bight: nobody needs an end for it.
TEST(KnotCurveCommand, TheHarnessHitchIsTiedWithoutTheEnds) {
  const std::string steps = RunTact({"knot", "tie", "harness_hitch", "--moves", "R1,R2,R3"}).out;
  EXPECT_TRUE(steps.ends_with("\n4 steps, proved shortest.\n")) << steps;
}

// [thesis, 5.4.2] on the bowline: in each transition the Cross move or R_I; more than one in the first and the fourth only;
// the third P-data is its own equivalent.
TEST(KnotCurveCommand, TheBowlineIsRecognizedAsTheThesisTells) {
  const Answer answer = Recognize("bowline_tied");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.out,
            "1: 0 intersections, /; the same from either end\n"
            "   R1 add: segment 1, attribute 3 over/+\n"
            "   or Cross add: selective end, segment 1, attribute 3 over/+\n"
            "   or Cross add: other end, segment 1, attribute 4 under/+\n"
            "2: 1 intersection, 2 1 / 3 4\n"
            "   Cross add: selective end, segment 2, attribute 4 under/+\n"
            "3: 2 intersections, 3 4 1 2 / 4 3 3 4; the same from either end\n"
            "   Cross add: selective end, segment 3, attribute 3 over/+\n"
            "4: 3 intersections, 4 5 6 1 2 3 / 3 4 3 4 3 4\n"
            "   Cross add: other end, segment 1, attribute 1 over/-\n"
            "   or Cross add: selective end, segment 7, attribute 2 under/-\n"
            "5: 4 intersections, 8 5 6 7 2 3 4 1 / 2 3 4 3 4 3 4 1\n"
            "   Cross add: selective end, segment 8, attribute 1 over/-\n"
            "6: 5 intersections, 9 10 6 7 8 3 4 5 1 2 / 1 2 3 4 3 4 3 4 2 1\n"
            "   Cross add: selective end, segment 6, attribute 1 over/-\n"
            "7: 6 intersections, 7 11 12 8 9 10 1 4 5 6 2 3 / 1 1 2 3 4 3 2 4 3 4 2 1\n"
            "   Cross add: selective end, segment 10, attribute 2 under/-\n"
            "8: 7 intersections, 11 8 13 14 9 10 12 2 5 6 1 7 3 4 / 2 1 1 2 3 4 3 2 4 3 1 4 2 1\n");
}

// [thesis, 5.4.2, Fig. 5.18]: with the third, the sixth and the seventh P-data read off from the wrong end, the third cannot
// be told, the others are found, and the moves are those of before.
TEST(KnotCurveCommand, WrongEndsAreRepairedAsTheThesisTells) {
  std::string repaired = Recognize("bowline_tied_wrong_ends").out;
  EXPECT_EQ(CountLines(repaired, "3: 2 intersections, 3 4 1 2 / 4 3 3 4; the same from either end"), 1);
  std::istringstream lines(repaired), right(Recognize("bowline_tied").out);
  std::string line, right_line;
  while (std::getline(lines, line)) {
    ASSERT_TRUE(std::getline(right, right_line));
    const bool wrong = line.starts_with("6:") || line.starts_with("7:");
    EXPECT_EQ(line.ends_with("; read off from the other end"), wrong) << line;
    if (!wrong) {
      EXPECT_EQ(line, right_line);
    }
  }
  EXPECT_FALSE(std::getline(right, right_line));
}

// [thesis, 5.4.2] on the bow: R_II realizes the fourth, the sixth and the seventh transition.
TEST(KnotCurveCommand, TheBowIsRecognizedAsTheThesisTells) {
  const Answer answer = Recognize("bow_tied");
  EXPECT_EQ(answer.status, 0) << answer.err;
  std::istringstream lines(answer.out);
  int transition = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line[0] != ' ') {
      ++transition;
    } else {
      EXPECT_EQ(line.find("R2 add") != std::string::npos,
                transition == 4 || transition == 6 || transition == 7)
          << line;
    }
  }
  EXPECT_EQ(transition, 8);
  EXPECT_EQ(CountLines(answer.out, "   no single move"), 0);
}

TEST(KnotCurveCommand, TheViewIsGivenOrChosenAndSaid) {
  const std::string from_below =
      RunTact({"knot", "convert", "overhand", "--to", "json", "--view", "0,0,-1"}).out;
  // Turned over, the shape and the heights are mirrored: signs stay, over and under change places.
  EXPECT_EQ(from_below, "{\"sigma\":[4,5,6,1,2,3],\"attr\":[4,3,4,3,4,3]}\n");
  const Answer chosen = RunTact({"knot", "check", "bow_tied", "--view", "auto"});
  EXPECT_EQ(chosen.status, 2);
  const Answer automatic = RunTact({"knot", "recognize", "bow_tied", "--view", "auto"});
  EXPECT_EQ(automatic.status, 0);
  EXPECT_TRUE(automatic.err.starts_with("tact: note: --view auto: seen from (")) << automatic.err;
  EXPECT_EQ(RunTact({"knot", "check", "2 1 / 3 4", "--view", "auto"}).err, "");
}

TEST(KnotCurveCommand, BadCurvesAndViewsAreRefused) {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& message) {
    const Answer answer = RunTact(arguments);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err, "tact: " + message + "\n");
  };
  refused({"knot", "check", "overhand", "--view", "up"}, "--view: expected X,Y,Z or auto, got \"up\"");
  refused({"knot", "check", "overhand", "--view=0,0,0"},
          "--view: expected a direction that is not zero, got \"0,0,0\"");
  refused({"knot", "tie", "bow_tied"},
          "examples/knots/bow_tied.xyz:1:1: expected one P-data or curve, got more; tact knot recognize "
          "reads steps");
  refused({"knot", "faces", "0 0 0\n0 0 1\n"},
          "<argument>:2:1: expected edges that are seen as lines, got one along the view: that of points 1 "
          "and 2; so it "
          "is seen from (0, 0, 1), --view auto tries others");
}

}  // namespace
}  // namespace tact::cli

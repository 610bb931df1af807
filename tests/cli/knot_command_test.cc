#include <gtest/gtest.h>

#include <algorithm>

#include "robot/input/knot_examples.h"
#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

using Words = std::vector<std::string>;

// The P-data of the thesis' Figures 5.2 and 5.16.
const std::string kFigure2 = R"({"sigma":[4,5,6,1,2,3],"attr":[3,1,2,4,2,1]})";
const std::string kFigure16 = R"({"sigma":[4,5,6,1,2,3],"attr":[3,4,3,4,3,4]})";
// Two ends on two faces; its shadow has two intersections and three faces.
const std::string kCurl = "3 4 1 2 / 1 2 2 1";
// Planar parts, a handle: the curl in the loop of a kink (reducible.h).
const std::string kHandle = "6 4 5 2 3 1 / 1 1 2 2 1 2";

std::string Out(const Words& arguments, const std::string& input = "") {
  const Answer answer = RunTact(arguments, input);
  EXPECT_EQ(answer.status, 0) << answer.err;
  return answer.out;
}

void ExpectRefused(const Words& arguments, const std::string& message) {
  const Answer answer = RunTact(arguments);
  EXPECT_EQ(answer.status, 2) << ::testing::PrintToString(arguments);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(answer.err, "tact: " + message + "\n");
}

// The move objects of `tact knot moves --json`.
Words MovesOf(const std::string& json) {
  Words moves;
  for (size_t at = json.find("{\"kind\""); at != std::string::npos; at = json.find("{\"kind\"", at + 1))
    moves.push_back(json.substr(at, json.find('}', at) + 1 - at));
  return moves;
}

// By hand: the strand's heights are O O U U U O; signs + - -; faces as in the thesis' example, whose shadow it shares.
TEST(KnotCommand, ChecksThesisFigure2) {
  EXPECT_EQ(Out({"knot", "check", kFigure2}),
            "P-data              4 5 6 1 2 3 / 3 1 2 4 2 1\n"
            "on a sphere         yes: 4 faces - 7 segments + 5 intersections and ends = 2\n"
            "intersections       3\n"
            "writhe              -1\n"
            "alternating         no\n"
            "ends on one face    yes\n"
            "irreducible         yes\n"
            "from the other end  4 5 6 1 2 3 / 1 2 4 2 1 3\n"
            "canonical form      4 5 6 1 2 3 / 1 2 4 2 1 3\n"
            "mirrored shape      4 5 6 1 2 3 / 1 3 4 2 4 3\n"
            "mirrored heights    4 5 6 1 2 3 / 2 4 3 1 3 4\n");
}

TEST(KnotCommand, ChecksThesisFigure16InJson) {
  EXPECT_EQ(
      Out({"knot", "check", "1 2 3 4 5 6 / 4 5 6 1 2 3 / 3 4 3 4 3 4", "--json"}),
      R"({"p_data":)" + kFigure16 +
          R"(,"planar":true,"genus":0,"crossings":3,"segments":7,"faces":4,"writhe":3,"alternating":true,)"
          R"("ends_on_one_face":true,"irreducible":true,"parts":[{"p_data":)" +
          kFigure16 +
          R"(,"segment":1}],"equivalent":{"sigma":[4,5,6,1,2,3],"attr":[4,3,4,3,4,3]},)"
          R"("canonical":)" +
          kFigure16 +
          R"(,"mirror_shape":{"sigma":[4,5,6,1,2,3],"attr":[1,2,1,2,1,2]},)"
          R"("mirror_heights":{"sigma":[4,5,6,1,2,3],"attr":[2,1,2,1,2,1]}})"
          "\n");
}

TEST(KnotCommand, ChecksWhatASphereDoesNotHold) {
  const std::string text = Out({"knot", "check", kHandle});
  EXPECT_NE(text.find("no, genus 1: 2 faces - 7 segments + 5 intersections and ends = 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("irreducible         no, 2 parts:\n"
                      "  part 1            2 1 / 1 2\n"
                      "  part 2            3 4 1 2 / 1 2 2 1  in segment 2 of those above\n"),
            std::string::npos)
      << text;
}

// Thesis, 5.4.1: f1 = {e1,e4}, f2 = {e2,e5}, f3 = {e1,e5,e3}, f4 = {e4,e2,e3}; its edge e_s is segment s + 1. Both ends,
// which the thesis' graph leaves out, lie on f4.
TEST(KnotCommand, FacesAreThoseOfTheThesis) {
  EXPECT_EQ(Out({"knot", "faces", kFigure16}),
            "4 faces; each walk has its face on the left: +s is segment s away from the selective end, -s "
            "toward it\n"
            "1: -1 +1 +5 +3 +7 -7 +4  selective end, other end\n"
            "2: -2 -4 -6\n"
            "3: +2 -5\n"
            "4: -3 +6\n");
  EXPECT_EQ(
      Out({"knot", "faces", kFigure16, "--json"}),
      R"({"count":4,"genus":0,"faces":[[-1,1,5,3,7,-7,4],[-2,-4,-6],[2,-5],[-3,6]],"selective_end_on":1,)"
      R"("other_end_on":1})"
      "\n");
}

// From one kink: the loop of R1, or either end drawn back; the kink read from its other end is not the same P-data, but
// both are straight without it.
TEST(KnotCommand, MovesBetweenTwoNameEveryExplanation) {
  EXPECT_EQ(
      Out({"knot", "moves", "2 1 / 3 4", "/"}),
      "R1 remove: segment 1, attribute 3 over/+\n"
      "Cross remove: selective end, segment 1, attribute 3 over/+\n"
      "Cross remove: other end, segment 1, attribute 4 under/+\n"
      "R1 remove: segment 1, attribute 3 over/+; then the other end is the selective one\n"
      "Cross remove: selective end, segment 1, attribute 3 over/+; then the other end is the selective one\n"
      "Cross remove: other end, segment 1, attribute 4 under/+; then the other end is the selective one\n");
  EXPECT_EQ(Out({"knot", "moves", kFigure2, kFigure16}), "no single move turns the first into the second\n");
  EXPECT_EQ(Out({"knot", "moves", kFigure2, kFigure16, "--json"}), "{\"moves\":[]}\n");
}

// The triangle of segments 2, 4, 6 has the strand 2 over both others and 4 under both; columns 1, 2 and 4, 5 bound a lens.
TEST(KnotCommand, MovesOfFigure2ThatAddNothing) {
  std::string found;
  for (const std::string& move : MovesOf(Out({"knot", "moves", kFigure2, "--json"}))) {
    if (move.find("\"add\"") == std::string::npos) found += move + "\n";
  }
  EXPECT_EQ(
      found,
      R"({"kind":"R2","direction":"remove","segments":[1,2],"end":null,"selective_end":"same","attr":3,"order":"same"})"
      "\n"
      R"({"kind":"R3","direction":"shift","segments":[2,6,4],"end":null,"selective_end":"same","attr":null,"order":null})"
      "\n"
      R"({"kind":"Cross","direction":"remove","segments":[3],"end":"selective","selective_end":"same","attr":3,"order":null})"
      "\n"
      R"({"kind":"Cross","direction":"remove","segments":[3],"end":"other","selective_end":"same","attr":1,"order":null})"
      "\n");
}

// apply takes each object that moves prints, and leads where moves was told, for both choices of the selective end.
TEST(KnotCommand, ApplyInvertsMoves) {
  const Words moves = MovesOf(Out({"knot", "moves", kFigure2, "--json"}));
  for (size_t i = 0; i < moves.size(); i += 12) {
    const std::string b = Out({"knot", "apply", kFigure2, moves[i], "--json"});
    const Words explanations = MovesOf(Out({"knot", "moves", kFigure2, b, "--json"}));
    EXPECT_NE(std::find(explanations.begin(), explanations.end(), moves[i]), explanations.end()) << moves[i];
    for (const std::string& explanation : explanations)
      EXPECT_EQ(Out({"knot", "apply", kFigure2, explanation, "--json"}), b) << explanation;
  }
  const std::string reversed = R"({"sigma":[2,1],"attr":[4,3]})";
  for (const std::string& move : MovesOf(Out({"knot", "moves", "/", reversed, "--json"})))
    EXPECT_EQ(Out({"knot", "apply", "/", move, "--json"}), reversed + "\n");
}

TEST(KnotCommand, AppliesTheHelpTextsExample) {
  EXPECT_EQ(Out({"knot", "apply", "2 1 / 3 4", R"({"kind":"R1","direction":"add","segments":[2],"attr":3})"}),
            "1 2 3 4\n4 3 2 1\n3 3 4 4\n");
}

TEST(KnotCommand, ConvertsThesisFigure16) {
  const auto to = [](const std::string& form) { return Out({"knot", "convert", kFigure16, "--to", form}); };
  EXPECT_EQ(to("rows"), "1 2 3 4 5 6\n4 5 6 1 2 3\n3 4 3 4 3 4\n");
  EXPECT_EQ(to("json"), kFigure16 + "\n");
  EXPECT_EQ(to("gauss"), "O1+ U2+ O3+ U1+ O2+ U3+\n");
  EXPECT_EQ(to("extended-gauss"), "1 -2 3 -1 2 -3 +++\n");
  EXPECT_EQ(to("pd"), "PD[X[3,1,4,0],X[1,5,2,4],X[5,3,6,2]]\n");
  EXPECT_EQ(to("dt"), "4 6 2\n");  // KnotInfo, 3_1
}

TEST(KnotCommand, ConvertSaysWhatIsLost) {
  const Answer open = RunTact({"knot", "convert", kCurl, "--to", "pd"});
  EXPECT_EQ(open.out, "PD[X[2,0,3,1],X[1,3,2,4]]\n");
  EXPECT_EQ(open.err, "");
  const Answer closed = RunTact({"knot", "convert", kCurl, "--to", "dt", "--close", "over"});
  EXPECT_EQ(closed.out, "4 -6 2\n");
  EXPECT_EQ(closed.err,
            "tact: note: closed by an arc that crosses 1 segment: where the ends were is lost\n"
            "tact: note: a DT code does not tell a part of the knot from its mirror image\n");
  EXPECT_EQ(
      Out({"knot", "convert", "2 1 / 3 4", "--to", "pd", "--close", "under", "--json"}),
      R"({"form":"pd","closed":true,"text":"PD[X[2,2,1,1]]","loses":["closed by an arc that crosses 0 segments: )"
      R"(where the ends were is lost","a PD code of one intersection does not tell which way the knot runs"]})"
      "\n");
}

TEST(KnotCommand, RefusesWithAReason) {
  const std::string genus =
      "<argument>:1:1: expected a diagram on a sphere, where 3 intersections make 4 faces, got 2 faces: "
      "genus 1";
  ExpectRefused({"knot", "moves", kHandle}, genus);
  ExpectRefused({"knot", "moves", "/", kHandle}, genus);
  ExpectRefused({"knot", "apply", kHandle, "{}"}, genus);
  ExpectRefused({"knot", "convert", kHandle, "--close", "over"}, genus);
  ExpectRefused({"knot", "convert", kCurl, "--to", "dt"},
                "--to dt: expected --close over or under since the ends lie on two faces, got neither");
  ExpectRefused({"knot", "convert", kCurl, "--to", "svg"},
                "--to: expected rows, json, gauss, extended-gauss, pd or dt, got \"svg\"");
  ExpectRefused({"knot", "convert", kCurl, "--close", "left"},
                "--close: expected over or under, got \"left\"");
  ExpectRefused({"knot", "apply", "2 1 / 3 4", R"({"kind":"R1","direction":"add","segments":[9],"attr":3})"},
                "MOVE: expected a segment from 1 to 3, got 9");
  ExpectRefused({"knot", "check", "4 5 6 / 1 2 3"},
                "<argument>:1:1: expected two columns for each intersection, got 3");
  ExpectRefused({"knot", "check", "granny"}, "\"granny\": expected a file, P-data or one of the examples (" +
                                                 input::KnotExampleNames() + "), got none of these");
}

TEST(KnotCommand, ReadsFilesAndStandardInput) {
  const TemporaryFile file("overhand.txt", "1 2 3 4 5 6\n4 5 6 1 2 3\n3 4 3 4 3 4\n");
  EXPECT_EQ(Out({"knot", "convert", file.path(), "--to", "json"}), kFigure16 + "\n");
  EXPECT_EQ(Out({"knot", "convert", "-", "--to", "json"}, "O1+U2+O3+U1+O2+U3+\n"), kFigure16 + "\n");
}

// 10,000 kinks side by side: each is a part of its own.
TEST(KnotCommand, TenThousandIntersectionsAreAnswered) {
  std::string mates, attributes;
  for (int i = 1; i < 20000; i += 2) {
    mates += std::to_string(i + 1) + " " + std::to_string(i) + " ";
    attributes += "1 2 ";
  }
  const TemporaryFile file("kinks.txt", mates + "\n" + attributes + "\n");
  const std::string text = Out({"knot", "check", file.path()});
  EXPECT_NE(text.find("yes: 10001 faces - 20001 segments + 10002 intersections and ends = 2\n"),
            std::string::npos);
  EXPECT_NE(text.find("no, 10000 parts:\n"), std::string::npos);
  const Answer moves = RunTact({"knot", "moves", file.path()});
  EXPECT_EQ(moves.status, 1);
  EXPECT_EQ(moves.err.substr(0, 53), "tact: undecided: moves: expected at most 1000000 move");
}

}  // namespace
}  // namespace tact::cli

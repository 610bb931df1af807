#include "robot/input/knot_text.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "algebra/knot/gauss_code.h"
#include "algebra/knot/pd_code.h"
#include "robot/input/knot_examples.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::input {
namespace {

// The P-data of Figures 5.2 and 5.16 of the thesis.
const knot::PData kFigure2({4, 5, 6, 1, 2, 3}, {3, 1, 2, 4, 2, 1});
const knot::PData kFigure16({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});

knot::PData Parse(const std::string& text) { return ParsePData(text, "text"); }

std::string Refusal(const std::string& text) {
  try {
    return "accepted: " + Parse(text).ToJson();
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(KnotText, EveryNotationOfTheThesisExamplesReadsTheSame) {
  for (const char* text :
       {R"({"sigma":[4,5,6,1,2,3],"attr":[3,4,3,4,3,4]})",
        R"( { "name":"overhand", "attr":[3,4,3,4,3,4], "sigma":[4,5,6,1,2,3] } )",
        "1 2 3 4 5 6\n4 5 6 1 2 3\n3 4 3 4 3 4\n", "1 2 3 4 5 6 / 4 5 6 1 2 3 / 3 4 3 4 3 4",
        "4 5 6 1 2 3/3 4 3 4 3 4", "4,5,6,1,2,3\r\n\r\n3,4,3,4,3,4",
        "1 2 3 4 5 6 /\n4 5 6 1 2 3 /\n3 4 3 4 3 4\n", "O1+ U2+ O3+ U1+ O2+ U3+", "o1+u2+o3+u1+o2+u3+",
        "O2+,U3+,O1+,U2+,O3+,U1+", "1 -2 3 -1 2 -3 / + + +", "1 -2 3 -1 2 -3 +++", "{1,-2,3,-1,2,-3},{+,+,+}",
        "(1 -2 3 -1 2 -3),(+ + +)", "PD[X[3,1,4,0],X[1,5,2,4],X[5,3,6,2]]",
        "[[3,1,4,0],[1,5,2,4],[5,3,6,2]]"}) {
    EXPECT_EQ(Parse(text), kFigure16) << text;
  }
  EXPECT_EQ(Parse("4 5 6 1 2 3 / 3 1 2 4 2 1"), kFigure2);
  EXPECT_EQ(Parse("O1+ O2- U3- U1+ U2- O3-"), kFigure2);
}

// Knoto-ID, examples/3_1L_diagram_open_PD.txt and examples/3_1L_diagram_Gauss.txt: one diagram in both notations. Its
// first strand is the lower one, all its intersections are negative.
TEST(KnotText, KnotoIdsTwoFilesOfOneDiagramAgree) {
  const knot::PData p = Parse("PD[\nX[0,3,1,4],\nX[4,1,5,2],\nX[2,5,3,6]\n];\n");
  EXPECT_EQ(p, Parse("-1 2 -3 1 -2 3 ---\n"));
  EXPECT_EQ(p, knot::PData({4, 5, 6, 1, 2, 3}, {2, 1, 2, 1, 2, 1}));
}

TEST(KnotText, TheStraightRopeHasNoColumns) {
  for (const char* text : {"/", R"({"sigma":[],"attr":[]})", "PD[]", "[]", " / \n"}) {
    EXPECT_EQ(Parse(text), knot::PData()) << text;
  }
}

TEST(KnotText, OneIntersection) {
  const knot::PData kink({2, 1}, {3, 4});
  for (const char* text : {"2 1 / 3 4", "O1+U1+", "1 -1 +", "PD[X[1,1,2,0]]"}) {
    EXPECT_EQ(Parse(text), kink) << text;
  }
}

void ExpectReadsBack(const knot::PData& p) {
  const auto gauss = knot::GaussCodeOf(p);
  for (const std::string& text :
       {p.ToJson(), ToText(gauss), ToExtendedText(gauss), ToText(knot::PdCodeOf(p))})
    ASSERT_EQ(Parse(text), p) << text;
}

TEST(KnotText, EveryFormReadsBackOnPlanarPDataToFourCrossings) {
  for (int c = 0; c <= 4; ++c) {
    for (const knot::PData& p : knot::PlanarPData(c)) ExpectReadsBack(p);
  }
}

TEST(KnotText, EveryFormReadsBackOnRandomRopesToFortyCrossings) {
  std::mt19937_64 random(19);
  for (int crossings = 5; crossings <= 40; ++crossings) ExpectReadsBack(knot::RandomPData(random, crossings));
}

TEST(KnotText, AnArgumentThatIsNeitherFileNorTextSaysSo) {
  for (const char* argument : {"no_such_knot", "folder/none.txt", "3_1.txt", "", " "}) {
    try {
      ReadPData(argument);
      ADD_FAILURE() << "accepted " << argument;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), "\"" + std::string(argument) +
                                               "\": expected a file, P-data or one of the examples (" +
                                               KnotExampleNames() + "), got none of these");
    }
  }
  EXPECT_EQ(ReadPData("2 1 / 3 4").columns(), 2);
}

TEST(KnotText, AHandleIsNoFault) {
  // Both strands of the second intersection turn against the first: genus 1 by Euler's formula, 1 face for 2 + 1.
  EXPECT_EQ(Parse("3 4 1 2 / 1 1 2 2").crossings(), 2);
}

TEST(KnotText, LinesAreCountedFromTheGivenOne) {
  try {
    ParsePData("\n4 x 6 1 2 3 / 3 4 3 4 3 4", "text", 7);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "text:8:3: expected a whole number, got \"x\"");
  }
  EXPECT_EQ(Refusal("  "), "text:1:1: expected P-data, got an empty text");
}

}  // namespace
}  // namespace tact::input

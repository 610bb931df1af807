#include <gtest/gtest.h>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

// Two vertices of an edge on a face: either may lift alone, both or none.
constexpr const char* kEdge =
    R"({"contacts":[{"point":[0,0,0],"planes":[[0,0,1]]},{"point":[2,0,0],"planes":[[0,0,1]]}]})"
    "\n";

TEST(ModesCommand, AnswersInJsonByHandCalculation) {
  EXPECT_EQ(RunTact({"modes", "-", "--json"}, kEdge).out,
            "{\"count\":4,\"modes\":[\"cc\",\"cs\",\"sc\",\"ss\"]}\n");
  EXPECT_EQ(RunTact({"modes", "-", "--json"}, "{\"contacts\":[]}").out, "{\"count\":1,\"modes\":[\"\"]}\n");
}

// Four corners of a square on a face: all kept; one edge; one corner; none. A diagonal cannot be kept alone.
TEST(ModesCommand, ASquareOnAFaceHasTheTenModesOfAQuadrilateralCone) {
  std::string square = R"({"contacts":[)";
  for (const char* point : {"[0,0,0]", "[1,0,0]", "[1,1,0]", "[0,1,0]"}) {
    if (square.back() != '[') square += ',';
    square.append(R"({"point":)").append(point).append(R"(,"planes":[[0,0,1]]})");
  }
  EXPECT_EQ(RunTact({"modes", "-", "--json"}, square + "]}").out,
            R"({"count":10,"modes":["cccc","ccss","cssc","csss","sccs","scss","sscc","sscs","sssc","ssss"]})"
            "\n");
}

TEST(ModesCommand, AnswersAListForPeople) {
  EXPECT_EQ(RunTact({"modes", "-"}, kEdge).out,
            "4 modes; c a contact that is kept, s one that separates, in the order of the "
            "contacts\ncc\ncs\nsc\nss\n");
}

// 22 singular contacts of two planes have 2^22 selections, more than the budget.
TEST(ModesCommand, OverTheBudgetIsUndecidedNotWrong) {
  std::string many = R"({"contacts":[)";
  for (int i = 0; i < 22; ++i) {
    if (i > 0) many += ',';
    many.append(R"({"point":[0,0,0],"planes":[[0,0,1],[1,0,)").append(std::to_string(i)).append("]]}");
  }
  const Answer answer = RunTact({"modes", "-", "--json"}, many + "]}");
  EXPECT_EQ(answer.status, 1);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(answer.err.substr(0, 29), "tact: undecided: <stdin>:1:1:") << answer.err;
}

}  // namespace
}  // namespace tact::cli

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

// An edge on a face, two vertices on a plane. By hand: translation keeps x and y, detaches along z; of the rotations
// those about x and z keep the contact, the one about y detaches, by type I.
constexpr const char* kEdge =
    R"({"contacts":[{"point":[0,0,0],"planes":[[0,0,1]]},{"point":[2,0,0],"planes":[[0,0,1]]}]})"
    "\n";
constexpr const char* kEdgeAnswer =
    R"({"singular":false,"translation":{"maintaining":2,"detaching":1,"constraining":0,"restricted":1},"rotation":{"maintaining":2,)"
    R"("detaching":1,"detaching_type1":1,"detaching_type2":0,"constraining":0,"restricted":1},"all":{"maintaining":4,"detaching":2,"constraining":0,"restricted":2}})"
    "\n";
// No contact at all: every motion maintains.
constexpr const char* kFree = R"({"contacts":[]})"
                              "\n";
constexpr const char* kFreeAnswer =
    R"({"singular":false,"translation":{"maintaining":3,"detaching":0,"constraining":0,"restricted":0},"rotation":{"maintaining":3,)"
    R"("detaching":0,"detaching_type1":0,"detaching_type2":0,"constraining":0,"restricted":0},"all":{"maintaining":6,"detaching":0,"constraining":0,"restricted":0}})"
    "\n";
// A vertex at a convex corner of two planes, one of which suffices: no non-singular contact restricts anything.
constexpr const char* kCorner = R"({"contacts":[{"point":[0,0,0],"planes":[[0,0,1],[1,0,0]]}]})"
                                "\n";
constexpr const char* kCornerAnswer =
    R"({"singular":true,"translation":{"maintaining":3,"detaching":0,"constraining":0,"restricted":2},"rotation":{"maintaining":3,)"
    R"("detaching":0,"detaching_type1":0,"detaching_type2":0,"constraining":0,"restricted":0},"all":{"maintaining":6,"detaching":0,"constraining":0,"restricted":2}})"
    "\n";

TEST(DofCommand, AnswersInJsonByHandCalculation) {
  EXPECT_EQ(RunTact({"dof", "--json", "-"}, kEdge).out, kEdgeAnswer);
  EXPECT_EQ(RunTact({"dof", "-", "--json"}, kFree).out, kFreeAnswer);
  EXPECT_EQ(RunTact({"dof", "-", "--json"}, kCorner).out, kCornerAnswer);
}

TEST(DofCommand, AnswersATableForPeople) {
  const Answer answer = RunTact({"dof", "-"}, kEdge);
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(answer.out,
            "             maintaining  detaching   type I  type II  constraining  restricted\n"
            "translation            2          1        -        -             0           1\n"
            "rotation               2          1        1        0             0           1\n"
            "all motion             4          2        -        -             0           2\n");
  EXPECT_NE(RunTact({"dof", "-"}, kCorner).out.find("The relation is singular"), std::string::npos);
}

TEST(DofCommand, SeveralRelationsAreNumberedForPeopleAndOneALineInJson) {
  const TemporaryFile file("three.json", std::string(kEdge) + "\n" + kFree + kCorner);
  EXPECT_EQ(RunTact({"dof", file.path(), "--json"}).out,
            std::string(kEdgeAnswer) + kFreeAnswer + kCornerAnswer);
  const std::string text = RunTact({"dof", file.path()}).out;
  for (const char* heading : {"relation 1\n", "\nrelation 2\n", "\nrelation 3\n"}) {
    EXPECT_NE(text.find(heading), std::string::npos) << heading;
  }
}

TEST(DofCommand, GivesTheAnswersBeforeABadLineAndNamesIt) {
  const Answer answer =
      RunTact({"dof", "-", "--json"}, std::string(kEdge) + kFree + "{\"contacts\":[{}]}\n" + kEdge);
  EXPECT_EQ(answer.status, 2);
  EXPECT_EQ(answer.out, std::string(kEdgeAnswer) + kFreeAnswer);
  EXPECT_EQ(answer.err, "tact: <stdin>:3:14: expected the key \"point\", got an empty object\n");
}

TEST(DofCommand, NamesTheFileLineAndColumnOfBadInput) {
  const TemporaryFile file("zero.json", "{\"contacts\":[\n {\"point\":[0,0,0],\n  \"planes\":[[0,0,0]]}]}\n");
  const Answer answer = RunTact({"dof", file.path()});
  EXPECT_EQ(answer.status, 2);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(answer.err,
            "tact: " + file.path() + ":3:13: expected a normal that is not zero, got [0, 0, 0]\n");
}

TEST(DofCommand, AnswersTenThousandLinesInOrder) {
  std::string input, expected;
  for (int i = 0; i < 10000; ++i) {
    input += i % 3 == 0 ? kEdge : kFree;
    expected += i % 3 == 0 ? kEdgeAnswer : kFreeAnswer;
  }
  const Answer answer = RunTact({"dof", "-", "--json"}, input);
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(answer.out, expected);
}

// A million points of one line of an edge on a face restrict what its two ends do.
TEST(FullDofCommand, AnswersAMillionContacts) {
  std::string input = "{\"contacts\":[";
  for (int i = 0; i < 1000000; ++i) {
    input += (i > 0 ? ",\n" : "") + std::string("{\"point\":[") + std::to_string(i) +
             ".5,0,0],\"planes\":[[0,0,1]]}";
  }
  const Answer answer = RunTact({"dof", "-", "--json"}, input + "]}");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.out, kEdgeAnswer);
}

}  // namespace
}  // namespace tact::cli

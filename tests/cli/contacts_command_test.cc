#include <gtest/gtest.h>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

const std::string kPeg = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/peg.off";
const std::string kSlot = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/slot.off";
// The peg's bottom edge on the rim of the slot and nothing else: state C of the example.
constexpr const char* kOnTheRim = R"({"t":["-400/101",0,"40/101"],"q":[10,0,1,0]})";

// By hand: the edge runs from y = -3 to 3 at the rim x = -2, z = 0; the planes are the block's top and the peg's bottom.
TEST(ContactsCommand, AnswersWithAContactRelationFile) {
  const Answer answer = RunTact({"contacts", kPeg, kSlot, "--unit", "mm", "--pose", kOnTheRim, "--json"});
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.out,
            R"({"contacts":[{"point":[-2,-3,0],"planes":[[0,0,1],[20,0,99]],"name":"edge 17 on edge 22"},)"
            R"({"point":[-2,3,0],"planes":[[0,0,1],[20,0,99]],"name":"edge 17 on edge 22"}]})"
            "\n");
}

TEST(ContactsCommand, ItsAnswerIsInputForDof) {
  const std::string seated = R"({"t":[0,0,-5],"q":[1,0,0,0]})";
  const Answer contacts = RunTact({"contacts", kPeg, kSlot, "--unit", "mm", "--pose", seated, "--json"});
  const Answer dof = RunTact({"dof", "-", "--json"}, contacts.out);
  const Answer direct = RunTact({"dof", "-", "--json"}, R"({"moving":")" + kPeg + R"(","fixed":")" + kSlot +
                                                            R"(","unit":"mm","pose":)" + seated + "}\n");
  EXPECT_EQ(dof.status, 0) << dof.err;
  EXPECT_EQ(dof.out, direct.out);
  EXPECT_NE(dof.out.find(R"("translation":{"maintaining":1,"detaching":1,"constraining":1,"restricted":2})"),
            std::string::npos)
      << dof.out;
}

TEST(ContactsCommand, TheCadFormWithNamedElementsTakesThoseOnly) {
  // One wall alone: a face on a face.
  const Answer dof =
      RunTact({"dof", "-", "--json"}, R"({"moving":")" + kPeg + R"(","fixed":")" + kSlot +
                                          R"(","unit":"mm","pose":{"t":[0,0,-2],"q":[1,0,0,0]},)"
                                          R"("contacts":[{"moving":{"face":3},"fixed":{"face":5}}]})"
                                          "\n");
  EXPECT_EQ(dof.status, 0) << dof.err;
  EXPECT_NE(dof.out.find(R"("all":{"maintaining":3,"detaching":3,"constraining":0,"restricted":3})"),
            std::string::npos)
      << dof.out;
}

TEST(ContactsCommand, PeopleSeePrimitivesPointsAndDofs) {
  const Answer answer = RunTact({"contacts", kPeg, kSlot, "--unit", "mm", "--pose", kOnTheRim});
  EXPECT_NE(answer.out.find("edge-edge  edge 17 on edge 22\n"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("at (-2, -3, 0)  normal (0, 0, 1) or (20, 0, 99)  (singular)"), std::string::npos)
      << answer.out;
}

TEST(ContactsCommand, TheDrawingHasADotForEachContact) {
  const TemporaryFile drawing("drawing.svg", "");
  ASSERT_EQ(
      RunTact({"contacts", kPeg, kSlot, "--unit", "mm", "--pose", kOnTheRim, "--svg", drawing.path()}).status,
      0);
  const Answer bad = RunTact({"contacts", kPeg, kSlot, "--unit", "mm", "--pose", kOnTheRim, "--svg",
                              drawing.path() + "/no/such/folder.svg"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("expected a folder to write in"), std::string::npos) << bad.err;
}

TEST(ContactsCommand, AUnitIsAskedForAndNeverGuessed) {
  const Answer answer = RunTact({"contacts", kPeg, kSlot, "--pose", kOnTheRim});
  EXPECT_EQ(answer.status, 2);
  EXPECT_EQ(answer.out, "");
  EXPECT_NE(answer.err.find("--unit: expected mm, cm, m or in"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace tact::cli

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

const std::string kFolder = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/";

TEST(PlanCommand, PlansTheSevenTransitionsSideBySide) {
  const Answer answer = RunTact({"plan", kFolder + "turned.json", "--json", "--samples", "10"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["unit"], "mm");
  ASSERT_EQ(json["transitions"].size(), 7U);
  const auto& first = json["transitions"][0];
  EXPECT_EQ(first["from"], "A");
  EXPECT_EQ(first["to"], "B");
  EXPECT_EQ(first["restricted"], nlohmann::json::parse("[[0,0],[1,1]]"));
  EXPECT_EQ(first["rotational"], 4);
  EXPECT_EQ(first["cure"], "A.6.1 edge-face");
  EXPECT_EQ(first["translational"], 3);
  EXPECT_EQ(first["samples"].size(), 21U);
  EXPECT_EQ(first["segments"][0]["kind"], "turn");
  EXPECT_EQ(first["segments"][1]["kind"], "line");
  ASSERT_EQ(first["ipopt"].size(), 2U);
  EXPECT_EQ(first["ipopt"][0]["definition"], "least");
  EXPECT_EQ(first["ipopt"][0]["knots"].size(), 21U);
  // (A.19) is not the least turn there, and Ipopt finds a smaller one.
  EXPECT_LT(first["ipopt"][0]["angle"].get<double>(), first["angle"].get<double>() - 1e-3);
  EXPECT_NEAR(first["ipopt"][1]["angle"].get<double>(), first["angle"].get<double>(), 1e-6);
  for (const auto& t : json["transitions"]) {
    EXPECT_TRUE(t["failure"].is_null());
    EXPECT_LT(t["violation"].get<double>(), 1e-12);
    EXPECT_EQ(t["overlap"], 0);
    EXPECT_TRUE(t["ipopt"][0]["solved"]);
  }
}

TEST(PlanCommand, PeopleSeeATableAndAPage) {
  const std::string page = (std::filesystem::temp_directory_path() / "tact_plan_test.html").string();
  const Answer answer =
      RunTact({"plan", kFolder + "demonstration.json", "--closed-form", "--reverse", "-o", page});
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find("H -> G"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("rotational 4, A.6.1 edge-face + translational 3, inverse"), std::string::npos);
  std::ifstream file(page);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("<svg"), std::string::npos);
  std::filesystem::remove(page);
}

void ExpectRefused(const std::string& text, const std::string& message) {
  const Answer answer = RunTact({"plan", "-"}, text);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find(message), std::string::npos) << answer.err;
}

TEST(PlanCommand, BadInputIsRefusedWithWhatWasExpected) {
  ExpectRefused(R"({"relations":[{"contacts":[]},{"contacts":[]}]})",
                "expected two models and the poses of the moving one, got contact relations");
  const std::string models =
      R"({"moving":")" + kFolder + R"(peg.off","fixed":")" + kFolder + R"(slot.off","unit":"mm",)";
  const std::string high = R"({"pose":{"t":[0,0,9],"q":[1,0,0,0]}})";
  ExpectRefused(models + R"("states":[)" + high + "]}", "expected two states or more, got 1");
  ExpectRefused(models + R"("tolerance":1,"states":[)" + high + "," + high + "]}",
                "expected \"tolerance\":0, got 1");
  ExpectRefused(models + R"("states":[)" + high + R"(,{"pose":{"t":[0,0,-6],"q":[1,0,0,0]}}]})",
                "interpenetrate");
  const Answer none = RunTact({"plan", kFolder + "turned.json", "--samples", "0"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("--samples: expected 1 to 100000"), std::string::npos) << none.err;
}

// From above and aside to the bottom of the slot: the line goes through the block, and the answer says so.
TEST(PlanCommand, ACollisionIsNamedAndTheStatusIsOne) {
  const std::string text =
      R"({"moving":")" + kFolder + R"(peg.off","fixed":")" + kFolder +
      R"(slot.off","unit":"mm","states":[{"name":"above","pose":{"t":[3,0,9],"q":[1,0,0,0]}},)"
      R"({"name":"seated","pose":{"t":[0,0,-5],"q":[1,0,0,0]}}]})";
  const Answer answer = RunTact({"plan", "-", "--closed-form"}, text);
  EXPECT_EQ(answer.status, 1) << answer.out << answer.err;
  EXPECT_NE(answer.out.find("the solids overlap by"), std::string::npos) << answer.out;
}

}  // namespace
}  // namespace tact::cli

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "provers/check/check.h"
#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

using nlohmann::json;

const std::string kOverhand = R"({"sigma":[4,5,6,1,2,3],"attr":[3,4,3,4,3,4]})";  // [thesis, 5.4.1]

json Tie(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"knot", "tie"});
  arguments.push_back("--json");
  const Answer answer = RunTact(arguments);
  EXPECT_EQ(answer.status, 0) << answer.err;
  return json::parse(answer.out);
}

// The answer, made a certificate, satisfies the checker.
bool Checks(const json& answer) {
  json certificate = {{"format", "tact-certificate"},
                      {"version", 1},
                      {"claim", "test"},
                      {"kind", "knot-tying"},
                      {"moves", json::array()},
                      {"p_data", {json::parse(R"({"sigma":[],"attr":[]})")}}};
  for (const json& step : answer["sequence"]) {
    certificate["moves"].push_back(step["move"]);
    certificate["p_data"].push_back(step["p_data"]);
  }
  return check::CheckCertificate(certificate.dump()).accepted;
}

TEST(KnotTie, TheOverhandKnotInThreeStepsThatTheCheckerAccepts) {
  const json answer = Tie({kOverhand});
  EXPECT_EQ(answer["steps"], 3);
  EXPECT_EQ(answer["proved_shortest"], true);
  EXPECT_EQ(answer["excluded_below"], 3);
  EXPECT_EQ(answer["sequence"][2]["p_data"], json::parse(kOverhand));
  EXPECT_TRUE(Checks(answer));
}

TEST(KnotTie, TheHeldEndCrossesNothing) {
  for (const std::string held : {"selective", "other"}) {
    const json answer = Tie({kOverhand, "--hold", held, "--moves", "Cross"});
    EXPECT_TRUE(Checks(answer));
    for (const json& step : answer["sequence"]) EXPECT_NE(step["move"]["end"], held);
  }
}

TEST(KnotTie, ForPeopleAStepIsALineInWords) {
  const Answer answer = RunTact({"knot", "tie", kOverhand, "--moves", "Cross", "--hold", "selective"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_NE(answer.out.find(" 3  the other end crosses under segment 3"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("3 steps, proved shortest."), std::string::npos) << answer.out;
}

TEST(KnotTie, WhatCannotBeTiedIsSaidWithItsReason) {
  const json answer = Tie({kOverhand, "--moves", "R1,R2,R3"});
  EXPECT_TRUE(answer["steps"].is_null());
  EXPECT_NE(answer["impossible"].get<std::string>().find("bracket"), std::string::npos);
  const json short_one = Tie({kOverhand, "--limit", "2"});
  EXPECT_TRUE(short_one["steps"].is_null());
  EXPECT_EQ(short_one["excluded_below"], 3);
}

TEST(KnotTie, AFolderHasThePageAndTheSteps) {
  const TemporaryFile place("knot.json", kOverhand);
  const auto folder = std::filesystem::path(place.path()).parent_path() / "steps";
  const json answer = Tie({place.path(), "-o", folder.string()});
  std::ifstream steps(folder / "steps.json");
  EXPECT_EQ(json::parse(steps), answer);
  std::ifstream page(folder / "index.html");
  const std::string text((std::istreambuf_iterator<char>(page)), {});
  EXPECT_NE(text.find("3 steps, proved shortest"), std::string::npos);
}

TEST(KnotTie, BadInputIsRefusedWithWhatWasExpected) {
  const auto refused = [](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), {"knot", "tie"});
    const Answer answer = RunTact(arguments);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_NE(answer.err.find(why), std::string::npos) << answer.err;
  };
  refused({R"({"sigma":[3,4,1,2],"attr":[3,3,4,4]})"}, ": genus 1");
  refused({kOverhand, "--moves", "R1,R4"}, "got 'R4'");
  refused({kOverhand, "--moves", ""}, "got");
  refused({kOverhand, "--hold", "left"}, "got 'left'");
  refused({kOverhand, "--limit", "-1"}, "got -1");
}

TEST(EnumerateMoves, TwoIntersectionsAreKnownByHand) {
  const Answer answer = RunTact({"enumerate", "moves", "--crossings", "2", "--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const json counts = json::parse(answer.out);
  EXPECT_EQ(counts["p_data"], 45);  // 1 + 2 * 2 + 10 * 4, OEIS A373325
  // Of two intersections, what an R2 makes of the straight rope is one step away, anything else two.
  EXPECT_EQ(counts["levels"][2]["steps"], (std::vector<int>{0, 8, 32}));
  EXPECT_EQ(RunTact({"enumerate", "moves", "--crossings", "7"}).status, 2);
  const Answer table = RunTact({"enumerate", "moves", "--crossings", "2"});
  EXPECT_NE(table.out.find("Pairs of P-data by the kinds"), std::string::npos) << table.out;
}

}  // namespace
}  // namespace tact::cli

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

const std::string kDemonstration = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/demonstration.json";

// The sub-skills and the critical transition that [thesis, 2.8.2] names.
TEST(RecognizeCommand, GivesTheSevenTransitionsOfThePegInsertion) {
  const Answer answer = RunTact({"recognize", kDemonstration, "--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  ASSERT_EQ(json["relations"].size(), 8U);
  ASSERT_EQ(json["transitions"].size(), 7U);
  const std::vector<std::string> align = {"make-contact-in-translation", "type1-make-contact-in-rotation"};
  const std::vector<std::vector<std::string>> skills = {
      align, {"slide-in-translation", "slide-in-rotation"}, {}, align, {"slide-in-rotation"}, {}, align};
  for (size_t i = 0; i < 7; ++i) {
    const auto& t = json["transitions"][i];
    EXPECT_EQ(t["sub_skills"], nlohmann::json(skills[i])) << i + 1;
    EXPECT_EQ(t["critical"], i == 5) << i + 1;
    EXPECT_EQ(t["practical"], true) << i + 1;
    EXPECT_EQ(t["from"], i);
    EXPECT_EQ(t["to"], i + 1);
    EXPECT_FALSE(t["why"].get<std::string>().empty());
  }
  EXPECT_EQ(json["relations"][7]["dof"]["rotation"]["constraining"], 2);
  EXPECT_EQ(json["relations"][7]["frames"], nlohmann::json({8, 8}));
}

TEST(RecognizeCommand, PeopleSeeATableAndTheReasons) {
  const Answer answer = RunTact({"recognize", kDemonstration});
  EXPECT_NE(answer.out.find("F           6         3 0 0 s      3 0 0     2 3         2 edge-edge\n"),
            std::string::npos)
      << answer.out;
  EXPECT_NE(answer.out.find("(6) F -> G   CRITICAL\n"), std::string::npos) << answer.out;
}

// Bringing an edge onto a parallel edge from free space: the rule selects a slide, and tact says what is wrong with it.
TEST(RecognizeCommand, ASlideWithoutSupportIsCalledAnApproach) {
  const Answer answer = RunTact(
      {"recognize", "-"},
      R"({"relations":[{"name":"free","contacts":[]},{"name":"rim","contacts":[)"
      R"({"point":[0,-1,0],"planes":[[0,0,1],[1,0,0]]},{"point":[0,1,0],"planes":[[0,0,1],[1,0,0]]}]}]})"
      "\n");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.out.find("slide-in-translation"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("this is an approach"), std::string::npos) << answer.out;
}

// From the command's own noise to states that tact plan reads again.
TEST(RecognizeCommand, ANoisyRecordingGivesRelationsAPageAndStates) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "tact_noisy_recording";
  std::filesystem::create_directories(folder);
  const std::string noisy = folder / "noisy.json", states = folder / "states.json",
                    page = folder / "scenes.html";
  ASSERT_EQ(RunTact({"demonstration", kDemonstration, "--noise", "1", "--degrees", "0.5", "--millimetres",
                     "0.05", "-o", noisy})
                .status,
            0);
  const Answer answer = RunTact({"recognize", noisy, "--noisy", "--json", "--states", states, "-o", page});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["scenes"].size(), 8U);
  EXPECT_EQ(json["noise"]["estimated"], true);
  const auto& relations = json["relations"];
  EXPECT_EQ(relations[0]["contacts"].size(), 0U);
  EXPECT_EQ(relations.back()["dof"]["rotation"]["restricted"], 3);  // H, on the bottom
  for (const auto& scene : json["scenes"]) EXPECT_LT(scene["relation"], relations.size());
  EXPECT_TRUE(std::filesystem::exists(page));
  const auto again = nlohmann::json::parse(RunTact({"recognize", states, "--json"}).out);
  ASSERT_EQ(again["relations"].size(), relations.size());
  for (size_t i = 0; i < relations.size(); ++i)
    EXPECT_EQ(again["relations"][i]["dof"], relations[i]["dof"]) << i;
  std::filesystem::remove_all(folder);
}

// One pose of six is 100 mm off: the answer comes with a word of doubt.
TEST(RecognizeCommand, AnOutlierIsDoubtedAloud) {
  const std::string models = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/";
  std::string states;
  for (const char* x : {"-6", "-6.1", "94", "-6.3", "-6.4", "-6.5"})
    states += std::string(states.empty() ? "" : ",") + R"({"pose":{"t":[)" + x + R"(,0,3],"q":[10,0,1,0]}})";
  const Answer answer =
      RunTact({"recognize", "-", "--noisy"}, R"({"moving":")" + models + R"(peg.off","fixed":")" + models +
                                                 R"(slot.off","unit":"mm","states":[)" + states + "]}\n");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_NE(answer.err.find("scene 3"), std::string::npos) << answer.err;
}

TEST(RecognizeCommand, WhatOnlyRecordingsHaveIsRefusedForExactStates) {
  EXPECT_EQ(
      RunTact({"recognize", kDemonstration, "--states", "states.json"}).err,
      "tact: --states: expected a recording, got a demonstration that is exact; --noisy treats it as one\n");
  EXPECT_EQ(RunTact({"recognize", kDemonstration, "--noise", "0", "1"}).err,
            "tact: --noise: expected two numbers above zero, degrees and a length, got 0\n");
}

}  // namespace
}  // namespace tact::cli

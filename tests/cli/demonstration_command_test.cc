#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

const std::string kDemonstration = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/demonstration.json";
const std::string kRecording =
    std::string(TACT_SOURCE_DIR) + "/../shared/data/peg_in_hole/peg_in_hole.pose.list";

TEST(DemonstrationCommand, SaysWhatARecordingHolds) {
  const Answer answer = RunTact({"demonstration", kDemonstration, "--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["scenes"], 8);
  EXPECT_EQ(json["unit"], "mm");
  EXPECT_EQ(json["times"], false);
  // The file: from z = 3 down to z = -5, x from -6 to 0, the tilt of A to E is twice the arc tangent of 1/10.
  EXPECT_DOUBLE_EQ(json["low"][2].get<double>(), -5);
  EXPECT_DOUBLE_EQ(json["high"][2].get<double>(), 3);
  EXPECT_DOUBLE_EQ(json["low"][0].get<double>(), -6);
  EXPECT_NEAR(json["turn"].get<double>(), 2 * std::atan(0.1), 1e-8);
}

TEST(DemonstrationCommand, WhatItWritesIsADemonstration) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "tact_demonstration";
  std::filesystem::create_directories(folder);
  const std::string out = (folder / "same.json").string();
  ASSERT_EQ(RunTact({"demonstration", kDemonstration, "-o", out}).status, 0);
  EXPECT_EQ(RunTact({"recognize", out, "--json"}).out, RunTact({"recognize", kDemonstration, "--json"}).out);
  ASSERT_EQ(RunTact({"demonstration", kDemonstration, "--every", "3", "-o", out}).status, 0);
  const Answer third = RunTact({"demonstration", out, "--json"});
  EXPECT_EQ(nlohmann::json::parse(third.out)["scenes"], 3);
  std::filesystem::remove_all(folder);
}

TEST(DemonstrationCommand, NoiseIsWhatItsSeedMakes) {
  const auto noisy = [](const std::string& seed) {
    return RunTact({"demonstration", kDemonstration, "--noise", seed, "--degrees", "1", "--millimetres",
                    "0.5", "--json"})
        .out;
  };
  EXPECT_EQ(noisy("1"), noisy("1"));
  EXPECT_NE(noisy("1"), noisy("2"));
}

TEST(DemonstrationCommand, BadOptionsAreRefused) {
  EXPECT_EQ(RunTact({"demonstration", kDemonstration, "--unit", "km"}).status, 2);
  EXPECT_EQ(RunTact({"demonstration", kDemonstration, "--every", "2", "--scenes", "3"}).status, 2);
  EXPECT_EQ(RunTact({"demonstration", kDemonstration, "--degrees", "2"}).status, 2);
  const Answer missing = RunTact({"demonstration", "no_such_file"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("no_such_file: expected a readable file"), std::string::npos) << missing.err;
}

// By hand: in state A nothing touches, in H the foot stands on the slot's bottom. Written to a pipe as well as to a file.
TEST(DemonstrationCommand, ContactsWithinAThresholdAreListed) {
  const Answer answer =
      RunTact({"demonstration", kDemonstration, "--contacts", "--threshold", "0.01", "--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["threshold"], 0.01);
  ASSERT_EQ(json["contacts"].size(), 8U);
  EXPECT_TRUE(json["contacts"][0]["near"].empty());
  EXPECT_GE(json["contacts"][7]["near"].size(), 4U);
  for (const auto& near : json["contacts"][7]["near"]) EXPECT_LE(std::abs(near["gap"].get<double>()), 0.01);
  const Answer text = RunTact({"demonstration", kDemonstration, "--contacts", "--threshold", "0.01"});
  EXPECT_NE(text.out.find("\nA           none\n"), std::string::npos) << text.out;
}

TEST(DemonstrationCommand, ThePublishedRecordingBeginsFreeAndEndsInContact) {
  if (!std::filesystem::exists(kRecording)) GTEST_SKIP() << "no shared data here";
  const Answer answer = RunTact({"demonstration", kRecording, "--contacts", "--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  ASSERT_EQ(json["contacts"].size(), 41U);
  EXPECT_TRUE(json["contacts"][0]["near"].empty());
  EXPECT_GE(json["contacts"][40]["near"].size(), 10U);
}

}  // namespace
}  // namespace tact::cli

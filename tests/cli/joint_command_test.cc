#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;
using Vector = std::array<double, 3>;

const std::string kRoot = TACT_SOURCE_DIR;
const std::string kExamples = kRoot + "/examples/joints/";
constexpr double kDegree = M_PI / 180;

Json Ask(Words arguments, int status = 0, const std::string& input = "") {
  arguments.insert(arguments.begin(), "joint");
  arguments.push_back("--json");
  const Answer answer = RunTact(arguments, input);
  EXPECT_EQ(answer.status, status) << answer.err;
  return Json::parse(answer.out, nullptr, false);
}

// The error in units of the one that is to be expected.
double AngleOff(const Json& parameter, Vector truth) {
  const auto value = parameter["value"].get<Vector>();
  const double dot = value[0] * truth[0] + value[1] * truth[1] + value[2] * truth[2];
  const double length = std::hypot(truth[0], truth[1], truth[2]);
  // An axis has no sense of its own; which one is printed follows from the motion.
  return std::acos(std::min(1.0, std::abs(dot) / length)) / parameter["error"].get<double>();
}

double DistanceOff(const Json& parameter, Vector truth) {
  const auto value = parameter["value"].get<Vector>();
  return std::hypot(value[0] - truth[0], value[1] - truth[1], value[2] - truth[2]) /
         parameter["error"].get<double>();
}

// How far a point lies from a line, in units of the error to be expected.
double LineOff(const Json& parameter, Vector point, Vector direction) {
  const auto value = parameter["value"].get<Vector>();
  const Vector d = {value[0] - point[0], value[1] - point[1], value[2] - point[2]};
  const Vector c = {d[1] * direction[2] - d[2] * direction[1], d[2] * direction[0] - d[0] * direction[2],
                    d[0] * direction[1] - d[1] * direction[0]};
  return std::hypot(c[0], c[1], c[2]) / std::hypot(direction[0], direction[1], direction[2]) /
         parameter["error"].get<double>();
}

// The truth stands at the head of each example. Errors beyond 3 times the expected one have chances below 1 in 1000.
constexpr double kMost = 3;

TEST(JointCommand, ADoorWithThreeWrongPoses) {
  const Json answer = Ask({kExamples + "door.txt"});
  EXPECT_EQ(answer["type"], "revolute");
  EXPECT_EQ(answer["outliers"], Json({40, 41, 77}));
  const Json& p = answer["parameters"];
  EXPECT_LT(AngleOff(p["direction_in_B"], {0.02, 0.01, 1}), kMost);
  EXPECT_LT(AngleOff(p["direction_in_A"], {0, 1, 0}), kMost);
  EXPECT_LT(LineOff(p["point_in_B"], {0.4, 0.1, 0}, {0.02, 0.01, 1}), kMost);
  EXPECT_LT(LineOff(p["point_in_A"], {-0.75, 0, 0.02}, {0, 1, 0}), kMost);
  EXPECT_NEAR(answer["coordinates"][0]["most"].get<double>(), 85 * kDegree, 3 * kDegree);
  EXPECT_NEAR(answer["noise"]["rotation"].get<double>(), 0.6 * kDegree, 0.1 * kDegree);
  EXPECT_NEAR(answer["noise"]["translation"].get<double>(), 0.003, 0.0005);
}

TEST(JointCommand, ADrawerInMillimetres) {
  const Json answer = Ask({kExamples + "drawer.csv"});
  EXPECT_EQ(answer["type"], "prismatic");
  EXPECT_EQ(answer["outliers"], Json::array());
  EXPECT_LT(AngleOff(answer["parameters"]["direction_in_B"], {1, 0.1, -0.05}), kMost);
  EXPECT_NEAR(answer["coordinates"][0]["most"].get<double>(), 0.35, 0.005);
}

TEST(JointCommand, AJarLidOfThreeTurns) {
  const Json answer = Ask({kExamples + "jar_lid.txt"});
  EXPECT_EQ(answer["type"], "screw");
  const Json& p = answer["parameters"];
  EXPECT_LT(AngleOff(p["direction_in_B"], {0.1, 0, 1}), kMost);
  EXPECT_LT(LineOff(p["point_in_B"], {0.05, 0.02, 0.1}, {0.1, 0, 1}), kMost);
  const double pitch = p["pitch"]["value"].get<double>();
  EXPECT_LT(std::abs(pitch - 0.012 / (2 * M_PI)), kMost * p["pitch"]["error"].get<double>());
  EXPECT_NEAR(answer["coordinates"][0]["most"].get<double>(), 6 * M_PI, 0.1);
}

TEST(JointCommand, APlierOfTwoTrackedHalves) {
  const Json answer = Ask({kExamples + "plier_half_a.txt", kExamples + "plier_half_b.txt"});
  EXPECT_EQ(answer["type"], "revolute");
  const Json& p = answer["parameters"];
  EXPECT_LT(AngleOff(p["direction_in_B"], {0, 0, 1}), kMost);
  EXPECT_LT(LineOff(p["point_in_B"], {0.06, 0.005, 0}, {0, 0, 1}), kMost);
  EXPECT_LT(LineOff(p["point_in_A"], {0.055, -0.004, 0.003}, {0, 0, 1}), kMost);
}

TEST(JointCommand, AUniversalJoint) {
  const Json answer = Ask({kExamples + "universal_joint.jsonl"});
  EXPECT_EQ(answer["type"], "two-axis");
  const Json& p = answer["parameters"];
  EXPECT_LT(AngleOff(p["direction_in_B"], {1, 0.2, 0}), kMost);
  EXPECT_LT(AngleOff(p["direction_in_A"], {0.1, 1, 0.2}), kMost);
  EXPECT_LT(DistanceOff(p["point_in_B"], {0.1, 0, 0.05}), kMost);
  EXPECT_LT(DistanceOff(p["point_in_A"], {-0.08, 0.01, 0}), kMost);
  EXPECT_LT(p["offset"]["value"].get<double>(), kMost * p["offset"]["error"].get<double>());
}

std::string ReadText(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(JointCommand, KeysAreThoseOfTheDesignWhateverTheAnswer) {
  for (const Words& arguments : {Words{kExamples + "drawer.csv"}, Words{"-"}}) {
    const bool known = arguments[0] != "-";
    const Json answer = Ask(arguments, known ? 0 : 1, "0 0 0 0 0 0 1\n");
    for (const char* key : {"type", "reason", "parameters", "covariance", "noise", "scores", "candidates",
                            "poses", "outliers", "coordinates", "values", "notes"}) {
      EXPECT_TRUE(answer.contains(key)) << key;
    }
    EXPECT_EQ(answer["values"].size(), known ? 80U : 0U);
    EXPECT_EQ(answer["type"], known ? "prismatic" : "undetermined");
    for (const auto& [name, parameter] : answer["parameters"].items()) {
      for (const char* key : {"value", "unit", "frame", "error", "error_unit", "determined"})
        EXPECT_TRUE(parameter.contains(key)) << name << key;
      EXPECT_EQ(answer["covariance"][name].size(), 3U);
    }
  }
}

// The same log inverted: the same joint with A and B exchanged, within two deviations, for the errors are taken to be independent in the other
// link now.
TEST(JointCommand, TheInverseLogExchangesTheLinks) {
  const Words door = {kExamples + "door.txt", "--type", "revolute"};
  Words inverse = door;
  inverse.push_back("--inverse");
  const Json a = Ask(door)["parameters"], b = Ask(inverse)["parameters"];
  EXPECT_LT(AngleOff(b["direction_in_A"], a["direction_in_B"]["value"].get<Vector>()), 2);
  EXPECT_LT(AngleOff(b["direction_in_B"], a["direction_in_A"]["value"].get<Vector>()), 2);
  EXPECT_LT(LineOff(b["point_in_A"], a["point_in_B"]["value"].get<Vector>(),
                    a["direction_in_B"]["value"].get<Vector>()),
            2);
}

TEST(JointCommand, TheUnitScalesLengthsAndNothingElse) {
  std::istringstream log(ReadText(kExamples + "door.txt"));
  std::ostringstream millimetres;
  for (std::string line; std::getline(log, line);) {
    if (line[0] == '#') continue;
    std::istringstream words(line);
    double n[8];
    for (double& value : n) words >> value;
    millimetres << n[0];
    for (int i = 1; i < 8; ++i) millimetres << " " << (i < 4 ? 1000 * n[i] : n[i]);
    millimetres << "\n";
  }
  const Json a = Ask({kExamples + "door.txt"})["parameters"];
  const Json b = Ask({"-", "--unit", "mm"}, 0, millimetres.str())["parameters"];
  for (const char* key : {"direction_in_A", "direction_in_B", "point_in_A", "point_in_B"}) {
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(a[key]["value"][i].get<double>(), b[key]["value"][i].get<double>(), 1e-6) << key;
  }
}

TEST(JointCommand, EveryMethodNamesTheSameJointOnGoodData) {
  for (const char* method : {"robust", "gaussian", "least-squares"}) {
    const Json p = Ask({kExamples + "jar_lid.txt", "--type", "screw", "--method", method})["parameters"];
    EXPECT_LT(AngleOff(p["direction_in_B"], {0.1, 0, 1}), 2 * kMost) << method;
    EXPECT_NEAR(p["pitch"]["value"].get<double>(), 0.012 / (2 * M_PI), 1e-5) << method;
  }
}

TEST(JointCommand, PosesHeldBackAreWithinTheNoise) {
  const Json held = Ask({kExamples + "jar_lid.txt", "--type", "screw", "--predict"})["held_back"];
  ASSERT_EQ(held["rotation"].size(), 150U);
  double squares = 0;  // of what a screw of one coordinate leaves: 0.8 degrees a component, two of three
  for (const Json& error : held["rotation"]) squares += std::pow(error.get<double>() / (0.8 * kDegree), 2);
  EXPECT_NEAR(squares / 150, 2, 0.6);
}

TEST(JointCommand, WhatThePosesCannotTellIsNotGuessed) {
  const std::string same = "0.1 0.2 0.3 0 0 0 1\n";
  std::string many;
  for (int i = 0; i < 50; ++i) many += same;
  for (const std::string& text : {same, same + same, many, std::string("0 0 0 0 0 0 1\n0.1 0 0 0 0 0 1\n")}) {
    const Json answer = Ask({"-"}, 1, text);
    EXPECT_EQ(answer["type"], "undetermined");
    EXPECT_FALSE(answer["reason"].get<std::string>().empty());
    EXPECT_FALSE(answer["candidates"].empty());
  }
}

TEST(JointCommand, ThePageStandsAlone) {
  const TemporaryFile page("door.html", "");
  const Answer answer = RunTact({"joint", kExamples + "door.txt", "-o", page.path()});
  EXPECT_EQ(answer.status, 0) << answer.err;
  const std::string html = ReadText(page.path());
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_EQ(html.find("href=\"http"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
  EXPECT_EQ(html.find("inf "), std::string::npos);
  EXPECT_NE(html.find("Revolute joint"), std::string::npos);
}

TEST(JointCommand, BadInputIsRefusedWithItsPlace) {
  const auto refused = [](Words arguments, const std::string& message, const std::string& input = "") {
    arguments.insert(arguments.begin(), "joint");
    const Answer answer = RunTact(arguments, input);
    EXPECT_EQ(answer.status, 2) << message;
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err.find("tact: " + message), 0U) << answer.err;
  };
  refused({"no/such.txt"}, "no/such.txt: expected a readable file, got: No such file or directory");
  refused({"-"}, "<stdin>:2:5: expected a finite number, got \"nan\"", "0 0 0 0 0 0 1\n0.1 nan 0 0 0 0 1\n");
  refused({"-", "--unit", "mile"}, "--unit: expected mm, cm, m or in, the unit of locations, got mile");
  refused({"-", "--type", "hinge"}, "--type: ");
  refused({"-", "--method", "gaussian"}, "--method gaussian: expected a --type, got none", "0 0 0 0 0 0 1\n");
  refused({kExamples + "plier_half_a.txt", kExamples + "plier_half_b.txt", "--inverse"},
          "--inverse: expected one log");
}

// Recordings of kitchen doors and drawers, beside the project where there are any.
TEST(FullJointCommand, EachRecordingOfAKitchenIsAnsweredAndPredictsPosesHeldBack) {
  const std::filesystem::path folder = std::filesystem::path(kRoot).parent_path() / "shared/data/kitchen";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no recordings at " << folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".log") continue;
    const Answer answer = RunTact({"joint", entry.path(), "--predict", "--json"});
    ASSERT_LE(answer.status, 1) << entry.path();
    const Json json = Json::parse(answer.out);
    if (json["type"] == "undetermined") continue;
    std::vector<double> off = json["held_back"]["translation"];
    std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
    EXPECT_LT(off[off.size() / 2], 0.01) << entry.path();  // a centimetre, half of the poses
  }
}

}  // namespace
}  // namespace tact::cli

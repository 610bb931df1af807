#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "tests/cli/enumerate_runs.h"

namespace tact::cli {
namespace {

namespace fs = std::filesystem;

class Enumerate : public EnumerateRuns {
 protected:
  Enumerate() : EnumerateRuns("dof-classes") {}
};

// docs/dof-classes.md has the counts, found by hand from the lemmas.
TEST_F(Enumerate, AnswersTheElevenDefinitionsInJson) {
  const Answer answer = Run({"--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  std::vector<int> classes;
  for (const auto& definition : json["definitions"]) {
    classes.push_back(definition["classes"]);
    EXPECT_EQ(definition["complete"], true);
    EXPECT_EQ(definition["upper_bound"], definition["classes"]);
    EXPECT_EQ(definition["list"].size(), definition["classes"]);
    uint64_t relations = 0;
    std::set<std::vector<int>> values;
    for (const auto& found : definition["list"]) {
      relations += found["count"].get<uint64_t>();
      EXPECT_EQ(found["values"].size(), definition["indices"].size());
      EXPECT_TRUE(values.insert(found["values"]).second);
    }
    EXPECT_EQ(relations, json["relations"]);
  }
  EXPECT_EQ(classes, (std::vector<int>{10, 10, 20, 28, 66, 90, 95, 66, 110, 107, 142}));
  EXPECT_EQ(json["world"]["name"], "corner");
  EXPECT_EQ(json["world"]["largest"], 7);
  EXPECT_EQ(json["definitions"][0]["indices"],
            (Arguments{"translation.maintaining", "translation.detaching", "translation.constraining"}));
}

// Twin: each witness, given to `tact dof`, has the indices of its class.
TEST_F(Enumerate, WitnessesHaveTheDofsOfTheirClass) {
  const auto json = nlohmann::json::parse(Run({"--json", "--contacts", "5"}).out);
  for (const auto& definition : json["definitions"]) {
    std::string relations;
    for (const auto& found : definition["list"]) relations += found["witness"].dump() + "\n";
    std::istringstream answers(RunTact({"dof", "-", "--json"}, relations).out);
    for (const auto& found : definition["list"]) {
      std::string line;
      ASSERT_TRUE(std::getline(answers, line));
      const auto dof = nlohmann::json::parse(line);
      std::vector<int> values;
      for (const std::string index : definition["indices"]) {
        const size_t dot = index.find('.');
        values.push_back(dof[index.substr(0, dot)][index.substr(dot + 1)]);
      }
      EXPECT_EQ(found["values"], values) << found["witness"];
    }
  }
}

TEST_F(Enumerate, ASmallWorldIsNotCompleteAndSaysSo) {
  const auto json = nlohmann::json::parse(Run({"--json", "--contacts", "1"}).out);
  EXPECT_EQ(json["relations"], 29);  // none, or one of 28 contacts
  EXPECT_EQ(json["definitions"][10]["classes"], 2);
  EXPECT_EQ(json["definitions"][10]["upper_bound"], 142);
  EXPECT_EQ(json["definitions"][10]["complete"], false);
  EXPECT_NE(Run({"--contacts", "1"}).out.find("Not complete"), std::string::npos);
}

// Two contacts at most, of which one at 0 along x is the first: its class is (2,1,0), rotation and all accordingly.
TEST_F(Enumerate, CsvHasALineAClass) {
  EXPECT_EQ(
      Run({"--csv", "--contacts", "1"}).out,
      "translation.maintaining,translation.detaching,translation.constraining,rotation.maintaining,"
      "rotation.detaching_type1,rotation.detaching_type2,rotation.constraining,all.maintaining,all.detaching,"
      "all.constraining,relations,contacts,witness\n"
      "2,1,0,3,0,0,0,5,1,0,28,1,\"{\"\"contacts\"\":[{\"\"point\"\":[0,0,0],\"\"planes\"\":[[1,0,0]]}]}\"\n"
      "3,0,0,3,0,0,0,6,0,0,1,0,\"{\"\"contacts\"\":[]}\"\n");
}

TEST_F(Enumerate, BoxesHave139) {
  const Answer answer = Run({"--world", "cube", "--contacts", "7"});
  EXPECT_NE(answer.out.find("there are 139 of the finest classes"), std::string::npos) << answer.out;
}

TEST_F(Enumerate, ArgumentsThatMakeNoSenseAreRefused) {
  const std::vector<std::pair<Arguments, std::string>> refused = {
      {{"--shard", "3/2"}, "--shard: expected i/n"},
      {{"--shard", "0/2"}, "--shard: expected i/n"},
      {{"--shard", "half"}, "--shard: expected i/n"},
      {{"--shard", "1/2"}, "-o DIR"},
      {{"--threads", "0"}, "--threads: expected 1 to"},
      {{"--threads", "-1"}, "--threads: expected 1 to"},
      {{"--threads", "two"}, "--threads"},
      {{"--world", "flat"}, "expected one of corner, cube, axis, diagonal, got flat"},
      {{"--contacts", "-1"}, "--contacts: expected 0 or more"},
      {{"--world", "diagonal", "--contacts", "50"}, "2^63"},
      {{"--world", "axis", "--contacts", "9"}, "--yes"},
      {{"--from", Folder("absent")}, "absent"},
      {{"--json", "--csv"}, "excludes"},
      {{"-o", fs::path(Folder("x")).parent_path()}, "holds something else"},
      {{"-o", Folder("beside")}, "got a file"},
      {{"-o", Folder("beside/below")}, "beside/below"},
      {{"-o", ""}, "expected a folder, got no name"},
      {{"-o", "/proc/none"}, "/proc/none"},
  };
  for (const auto& [arguments, said] : refused) {
    const Answer answer = Run(arguments);
    EXPECT_EQ(answer.status, 2) << said;
    EXPECT_EQ(answer.out, "") << said;
    EXPECT_NE(answer.err.find(said), std::string::npos) << answer.err;
  }
  EXPECT_NE(RunTact({"enumerate"}).err.find("one of dof-classes"), std::string::npos);
}

TEST_F(Enumerate, AFolderKeepsTheResultsAndRefusesAnotherRun) {
  const Answer first = Run({"--contacts", "3", "-o", Folder("run"), "--json"});
  ASSERT_EQ(first.status, 0) << first.err;
  const auto files = Files("run");
  EXPECT_EQ(files.at("classes.json"), first.out);
  EXPECT_EQ(files.at("classes.csv"), Run({"--contacts", "3", "--csv"}).out);
  EXPECT_NE(files.at("index.html").find("<svg"), std::string::npos);
  const Answer other = Run({"--contacts", "4", "-o", Folder("run")});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("\"largest\":3"), std::string::npos) << other.err;
  EXPECT_NE(other.err.find("\"largest\":4"), std::string::npos) << other.err;
  EXPECT_EQ(Files("run"), files);
}

TEST_F(Enumerate, ShardsAndThreadsMakeTheSameBytes) {
  const Arguments world = {"--contacts", "6"};  // three units
  const auto run = [&](Arguments more) {
    more.insert(more.end(), world.begin(), world.end());
    return Run(more);
  };
  ASSERT_EQ(run({"-o", Folder("single"), "--threads", "1"}).status, 0);
  const auto single = Files("single");

  const Answer part = run({"-o", Folder("parts"), "--shard", "2/2", "--json"});
  EXPECT_EQ(part.status, 0) << part.err;
  EXPECT_EQ(nlohmann::json::parse(part.out)["missing_shards"], (std::vector<int>{1}));
  EXPECT_FALSE(fs::exists(Folder("parts") + "/classes.json"));
  EXPECT_EQ(run({"-o", Folder("parts"), "--shard", "1/2", "--threads", "3"}).status, 0);
  EXPECT_EQ(Files("parts"), single);

  EXPECT_NE(run({"-o", Folder("a"), "--shard", "1/2"}).out.find("in shards 2 of 2"), std::string::npos);
  ASSERT_EQ(run({"-o", Folder("b"), "--shard", "2/2"}).status, 0);
  ASSERT_EQ(run({"-o", Folder("merged"), "--from", Folder("a"), "--from", Folder("b")}).status, 0);
  EXPECT_EQ(Files("merged"), single);
  EXPECT_EQ(run({"--from", Folder("a"), "--json"}).out, single.at("classes.json"));
}

TEST_F(Enumerate, ARunKilledAtAnyMomentEndsWithTheSameBytes) {
  const Arguments arguments = {"enumerate", "dof-classes", "--threads", "1", "-o", Folder("killed")};
  ASSERT_EQ(Run({"-o", Folder("single")}).status, 0);
  std::mt19937 random(6);
  int killed = 0;
  for (int i = 0; i < 10; ++i) {
    const std::chrono::milliseconds time(20 + random() % 300);
    killed += RunLimited(arguments, RLIM_INFINITY, time) == -1 ? 1 : 0;
  }
  EXPECT_GE(killed, 1);
  EXPECT_EQ(RunTact(arguments).status, 0);
  EXPECT_EQ(Files("killed"), Files("single"));
}

TEST_F(Enumerate, AFullDiskIsAnErrorAndALaterRunEnds) {
  const Arguments arguments = {"enumerate", "dof-classes", "--contacts", "6", "-o", Folder("full")};
  ASSERT_EQ(Run({"--contacts", "6", "-o", Folder("single")}).status, 0);
  const auto single = Files("single");
  // Room for nothing, for run.json, for the units, for classes.csv but not for classes.json.
  for (const rlim_t bytes : {0, 600, 20000, 60000}) {
    EXPECT_EQ(RunLimited(arguments, bytes, std::chrono::seconds(60)), 2) << bytes;
    for (const auto& [name, text] : Files("full")) EXPECT_EQ(text, single.at(name)) << bytes;
  }
  EXPECT_EQ(RunTact(arguments).status, 0);
  EXPECT_EQ(Files("full"), single);
}

}  // namespace
}  // namespace tact::cli

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "tests/cli/enumerate_runs.h"

namespace tact::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class EnumerateSteps : public EnumerateRuns {
 protected:
  EnumerateSteps() : EnumerateRuns("dof-transitions") {}

  // Of relations of at most three contacts, to which something is added.
  const json& AnswerOfFour() const {
    static const json answer = json::parse(Run({"--json", "--contacts", "4"}).out);
    return answer;
  }
};

// [thesis, 2.3] names 13; the other counts were found by hand from the rules of docs/dof-transitions.md.
TEST_F(EnumerateSteps, ThirteenStepsInTranslationByOneDefinition) {
  const json& answer = AnswerOfFour();
  std::vector<int> pairs;
  for (const json& definition : answer["translation_steps"]) {
    pairs.push_back(definition["pairs"]);
    EXPECT_EQ(definition["list"].size(), definition["pairs"]) << definition["definition"];
    EXPECT_EQ(definition["list"][0]["from"].size(), 3U);
  }
  EXPECT_EQ(pairs, (std::vector<int>{16, 6, 10, 10, 7, 13, 12, 40}));
}

// Twin: the DOFs that `tact dof` gives before and after are those of the classes.
TEST_F(EnumerateSteps, WitnessesStepFromClassToClass) {
  const json& answer = AnswerOfFour();
  ASSERT_EQ(answer["class_steps"].size(), 3U);
  for (const json& addition : answer["class_steps"]) {
    ASSERT_EQ(addition["definitions"].size(), 11U);
    std::string relations;
    const json& finest = addition["definitions"][10];
    ASSERT_FALSE(finest["list"].empty());
    EXPECT_EQ(finest["list"].size(), finest["pairs"]);
    for (const json& step : finest["list"]) {
      json after = step["witness"]["relation"];
      for (const json& contact : step["witness"]["added"]["contacts"]) after["contacts"].push_back(contact);
      relations += step["witness"]["relation"].dump() + "\n" + after.dump() + "\n";
    }
    std::istringstream answers(RunTact({"dof", "-", "--json"}, relations).out);
    const auto values = [&] {
      std::string line;
      std::getline(answers, line);
      const json dof = json::parse(line);
      std::vector<int> list;
      for (const std::string index : finest["indices"]) {
        const size_t dot = index.find('.');
        list.push_back(dof[index.substr(0, dot)][index.substr(dot + 1)]);
      }
      return list;
    };
    for (const json& step : finest["list"]) {
      EXPECT_EQ(step["from"], values()) << step;
      EXPECT_EQ(step["to"], values()) << step;
    }
  }
}

TEST_F(EnumerateSteps, EveryDefinitionHasEveryStepOnce) {
  const json& answer = AnswerOfFour();
  for (const json& addition : answer["class_steps"]) {
    for (const json& definition : addition["definitions"]) {
      uint64_t steps = definition["within"];
      std::set<std::pair<std::vector<int>, std::vector<int>>> pairs;
      for (const json& step : definition["list"]) {
        steps += step["count"].get<uint64_t>();
        EXPECT_NE(step["from"], step["to"]);
        EXPECT_EQ(step["from"].size(), definition["indices"].size());
        EXPECT_TRUE(pairs.emplace(step["from"], step["to"]).second);
      }
      EXPECT_EQ(steps, addition["steps"]) << addition["added"] << definition["name"];
    }
  }
  // A contact is added to none, one, two or three of 28.
  const int two = 28 * 27 / 2, three = 28 * 27 * 26 / 6;
  EXPECT_EQ(answer["relations"], 1 + 28 + two + three);
  EXPECT_EQ(answer["class_steps"][0]["steps"], 28 + 28 * 27 + two * 26 + three * 25);
  EXPECT_EQ(answer["class_steps"][0]["additions"], 28);
}

TEST_F(EnumerateSteps, AllThirtyInBothMotionsWithTheirSolids) {
  const json& answer = AnswerOfFour();
  const json& list = answer["dof_transitions"];
  ASSERT_EQ(list.size(), 60U);
  std::set<std::vector<std::string>> kinds;
  int practical = 0;
  for (const json& t : list) {
    const std::vector<std::string> kind = {t["motion"], t["from"], t["to"]};
    EXPECT_TRUE(kinds.insert(kind).second);
    EXPECT_NE(t["from"], t["to"]);
    EXPECT_EQ(t["occurs"], true) << t;
    practical += t["practical"].get<bool>() ? 1 : 0;
    const json& witness = t["witness"];
    EXPECT_TRUE(witness["path"]["kind"] == "line" || witness["path"]["kind"] == "rotation");
    EXPECT_GE(witness["moving"].size(), 1U);
    EXPECT_GE(witness["fixed"].size(), 1U);
    for (const char* state : {"before", "after"}) {
      const json relation = {{"contacts", witness[state]["contacts"]}};
      EXPECT_EQ(json::parse(RunTact({"dof", "-", "--json"}, relation.dump() + "\n").out),
                witness[state]["dof"]);
    }
  }
  EXPECT_EQ(practical, 40);  // 20 in translation, 20 in rotation [thesis, Fig. 2.5]
}

// A contact's row is new, or changes no maintaining DOF (docs/dof-transitions.md, Theorem 1).
TEST_F(EnumerateSteps, MaintainingBecomesConstrainingByEdgesAndFacesInRotationOnly) {
  const json& answer = AnswerOfFour();
  ASSERT_EQ(answer["maintaining_to_constraining"].size(), 6U);
  for (const json& blocks : answer["maintaining_to_constraining"]) {
    const bool some = blocks["added"] != "contact" && blocks["motion"] == "rotation";
    EXPECT_EQ(blocks["steps"].get<uint64_t>() > 0, some) << blocks;
    EXPECT_EQ(blocks.contains("witness"), some) << blocks;
    if (!some) continue;
    EXPECT_EQ(blocks["witness"]["relation"]["contacts"].size(), 1U);  // against the new ones
  }
}

// One contact's step from nothing: (2, 1, 0) in translation, all rotations stay, five of six motions in all.
TEST_F(EnumerateSteps, CsvHasALineAPairOfClasses) {
  const std::string csv = Run({"--csv", "--contacts", "1"}).out;
  EXPECT_NE(csv.find("\ncontact,3,0,0,3,0,0,0,6,0,0,2,1,0,3,0,0,0,5,1,0,28,\"{\"\"contacts\"\":[]}\",\"{"
                     "\"\"contacts\"\":[{\"\"point\"\":[0,0,0],\"\"planes\"\":[[1,0,0]]}]}\"\n"),
            std::string::npos)
      << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);  // and an edge's, and a face's
}

TEST_F(EnumerateSteps, TellsPeopleTheSame) {
  const std::string text = Run({"--contacts", "2"}).out;
  for (const char* said : {"13  one contact, or the two walls of a slot", "3 0 0        .       28",
                           "A bar comes down until an edge lies on the floor."})
    EXPECT_NE(text.find(said), std::string::npos) << text;
}

TEST_F(EnumerateSteps, ArgumentsThatMakeNoSenseAreRefused) {
  const std::vector<std::pair<Arguments, std::string>> refused = {
      {{"--contacts", "0"}, "--contacts: expected 1 or more, got 0"},
      {{"--world", "flat"}, "expected one of corner, cube, axis, diagonal, got flat"},
      {{"--world", "diagonal", "--contacts", "50"}, "2^63"},
      {{"--world", "axis", "--contacts", "7"}, "steps"},
      {{"--shard", "1/2"}, "-o DIR"},
      {{"--json", "--csv"}, "excludes"},
  };
  for (const auto& [arguments, said] : refused) {
    const Answer answer = Run(arguments);
    EXPECT_EQ(answer.status, 2) << said;
    EXPECT_EQ(answer.out, "") << said;
    EXPECT_NE(answer.err.find(said), std::string::npos) << answer.err;
  }
}

TEST_F(EnumerateSteps, AFolderOfTheOtherEnumerationIsRefused) {
  ASSERT_EQ(RunTact({"enumerate", "dof-classes", "--contacts", "1", "-o", Folder("run")}).status, 0);
  const auto files = Files("run");
  const Answer answer = Run({"--contacts", "1", "-o", Folder("run")});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("dof-classes"), std::string::npos) << answer.err;
  EXPECT_EQ(Files("run"), files);
}

TEST_F(EnumerateSteps, KillsAndShardsMakeTheSameBytes) {
  const Arguments world = {"--world", "cube", "--contacts", "5"};  // three units
  const auto run = [&](Arguments more) {
    more.insert(more.end(), world.begin(), world.end());
    return Run(more);
  };
  const Answer single = run({"-o", Folder("single"), "--threads", "1", "--json"});
  ASSERT_EQ(single.status, 0) << single.err;
  const auto files = Files("single");
  EXPECT_EQ(files.at("transitions.json"), single.out);
  EXPECT_TRUE(files.contains("transitions.csv"));
  EXPECT_NE(files.at("index.html").find("<svg"), std::string::npos);

  Arguments killed = {"enumerate", "dof-transitions", "-o", Folder("shards"), "--shard", "1/2"};
  killed.insert(killed.end(), world.begin(), world.end());
  std::mt19937 random(4);
  int cut = 0;
  for (int i = 0; i < 4; ++i) {
    const std::chrono::milliseconds time(10 + random() % 300);
    cut += RunLimited(killed, RLIM_INFINITY, time) == -1 ? 1 : 0;
  }
  EXPECT_GE(cut, 1);
  EXPECT_EQ(run({"-o", Folder("other"), "--shard", "2/2"}).status, 0);
  EXPECT_EQ(run({"-o", Folder("shards"), "--from", Folder("other"), "--threads", "2"}).status, 0);
  EXPECT_EQ(Files("shards"), files);
}

}  // namespace
}  // namespace tact::cli

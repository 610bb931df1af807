#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/cli/enumerate_runs.h"

namespace tact::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class EnumeratePData : public EnumerateRuns {
 protected:
  EnumeratePData() : EnumerateRuns("p-data") {}
};

// Codes by OEIS A373325, ends on one face by A054993; the rest by brute force (tests/enumerators/code_counts_test.cc).
TEST_F(EnumeratePData, AnswersEveryKey) {
  const Answer answer = Run({"--crossings", "4", "--json"});
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.out,
            "{\"crossings\":4,\"codes\":498,\"p_data\":7968,\"pairings\":68,\"irreducible\":{\"codes\":22,"
            "\"p_data\":352},"
            "\"up_to_reversal\":264,\"up_to_mirror\":249,\"up_to_both\":147,\"ends_on_one_face\":260}\n");
}

TEST_F(EnumeratePData, TheTableHasALineForEachNumberOfIntersections) {
  std::istringstream table(Run({"--crossings", "3"}).out);
  std::string line;
  std::getline(table, line);
  EXPECT_NE(line.find("up to reversal"), std::string::npos);
  for (const std::string codes : {"1", "2", "10", "66"}) {
    std::getline(table, line);
    std::istringstream fields(line);
    std::string n, first;
    fields >> n >> first;
    EXPECT_EQ(first, codes);
  }
}

// The one loop of each kind.
TEST_F(EnumeratePData, ListsTheCodes) {
  EXPECT_EQ(Run({"--crossings", "1", "--list"}).out,
            "{\"sigma\":[2,1],\"turn\":[1,-1]}\n{\"sigma\":[2,1],\"turn\":[-1,1]}\n");
  EXPECT_EQ(Run({"--crossings", "0", "--list"}).out, "{\"sigma\":[],\"turn\":[]}\n");
  const std::string list = Run({"--crossings", "5", "--list"}).out;
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 4072);
}

TEST_F(EnumeratePData, CountsCodesAloneFarther) {
  const Answer answer = Run({"--crossings", "11", "--codes", "--json"});
  EXPECT_EQ(answer.out, "{\"crossings\":11,\"codes\":2595131328}\n");  // OEIS A373325
  EXPECT_NE(Run({"--crossings", "2", "--codes"}).out.find(" 2                    10\n"), std::string::npos);
}

TEST_F(EnumeratePData, ArgumentsThatMakeNoSenseAreRefused) {
  const std::vector<std::pair<Arguments, std::string>> refused = {
      {{"--crossings", "-1"}, "--crossings: expected 0 to 15 (with --codes 20), got -1"},
      {{"--crossings", "16"}, "--crossings: expected 0 to 15"},
      {{"--crossings", "21", "--codes"}, "--crossings: expected 0 to 20, got 21"},
      {{"--crossings", "18", "--codes"}, "--yes"},
      {{"--crossings", "12"}, "--yes"},
      {{"--crossings", "many"}, "--crossings"},
      {{"--list", "--json"}, "excludes"},
      {{"--list", "--codes"}, "excludes"},
      {{"--list", "-o", Folder("x")}, "--list: expected no -o"},
      {{"--codes", "-o", Folder("x")}, "--codes: expected no -o"},
      {{"--shard", "2/3"}, "-o DIR"},
  };
  for (const auto& [arguments, said] : refused) {
    const Answer answer = Run(arguments);
    EXPECT_EQ(answer.status, 2) << said;
    EXPECT_EQ(answer.out, "") << said;
    EXPECT_NE(answer.err.find(said), std::string::npos) << answer.err;
  }
}

TEST_F(EnumeratePData, ShardsAndThreadsMakeTheSameBytes) {
  ASSERT_EQ(Run({"--crossings", "6", "-o", Folder("single"), "--threads", "1"}).status, 0);
  const auto single = Files("single");
  EXPECT_EQ(single.at("counts.json"), Run({"--crossings", "6", "--json"}).out);
  const Answer part = Run({"--crossings", "6", "-o", Folder("a"), "--shard", "1/2"});
  EXPECT_NE(part.out.find("in shards 2 of 2"), std::string::npos) << part.out;
  EXPECT_FALSE(fs::exists(Folder("a") + "/counts.json"));
  ASSERT_EQ(Run({"--crossings", "6", "-o", Folder("b"), "--shard", "2/2", "--threads", "3"}).status, 0);
  ASSERT_EQ(
      Run({"--crossings", "6", "-o", Folder("all"), "--from", Folder("a"), "--from", Folder("b")}).status, 0);
  EXPECT_EQ(Files("all"), single);
  const Answer other = Run({"--crossings", "5", "-o", Folder("all")});
  EXPECT_EQ(other.status, 2);
}

TEST_F(EnumeratePData, ARunKilledAtAnyMomentEndsWithTheSameBytes) {
  const Arguments arguments = {"enumerate", "p-data", "--crossings", "7",
                               "--threads", "1",      "-o",          Folder("killed")};
  ASSERT_EQ(Run({"--crossings", "7", "-o", Folder("single")}).status, 0);
  std::mt19937 random(4);
  int killed = 0;
  for (int i = 0; i < 6; ++i) {
    killed +=
        RunLimited(arguments, RLIM_INFINITY, std::chrono::milliseconds(5 + random() % 60)) == -1 ? 1 : 0;
  }
  EXPECT_GE(killed, 1);
  EXPECT_EQ(RunTact(arguments).status, 0);
  EXPECT_EQ(Files("killed"), Files("single"));
}

}  // namespace
}  // namespace tact::cli

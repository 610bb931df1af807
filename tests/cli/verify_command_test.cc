#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace tact::cli {
namespace {

TEST(VerifyCommand, WritesAReportOfTheClaimsAskedFor) {
  const TemporaryFile beside("beside", "");
  const std::string report = std::filesystem::path(beside.path()).parent_path() / "report";
  const Answer answer = RunTact({"verify", "--quick", "--only", "thesis.2.8.2.*", "-o", report});
  ASSERT_EQ(answer.status, 0) << answer.err;
  std::ifstream file(report + "/ledger.json");
  const auto ledger = nlohmann::json::parse(file);
  ASSERT_EQ(ledger["claims"].size(), 8U);
  for (const auto& claim : ledger["claims"]) {
    EXPECT_EQ(claim["verdict"], "reproduced") << claim["id"];
    for (const std::string path : claim["certificates"])
      EXPECT_TRUE(std::filesystem::exists(report + "/" + path)) << path;
  }
  EXPECT_TRUE(std::filesystem::exists(report + "/index.html"));
  std::filesystem::remove_all(report);
}

TEST(VerifyCommand, AnUnknownClaimIsRefusedWithTheListOfIds) {
  const Answer answer = RunTact({"verify", "--only", "thesis.9*"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("thesis.2.8.2.transition-1"), std::string::npos) << answer.err;
}

TEST(VerifyCommand, AFolderThatIsNoReportIsLeftAlone) {
  const TemporaryFile precious("precious.txt", "mine");
  const std::string folder = std::filesystem::path(precious.path()).parent_path();
  const Answer answer = RunTact({"verify", "--quick", "--only", "thesis.2.1.screw-form", "-o", folder});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(std::filesystem::exists(precious.path()));
}

}  // namespace
}  // namespace tact::cli

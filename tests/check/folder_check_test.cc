// Files, folders and ledgers, through the library and through the program.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "provers/check/check.h"
#include "tests/check/brute.h"

namespace tact::check {
namespace {

using brute::json;
namespace fs = std::filesystem;

// A folder of its own for every test, removed after it.
class FolderCheck : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "certificates"); }
  void TearDown() override { fs::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  void WriteLedger(const json& claims) const { Write("ledger.json", json{{"claims", claims}}.dump()); }
  Report Check() const {
    Report report;
    CheckPath(folder_.string(), report);
    return report;
  }

  // What the program prints, standard error too, and its exit status.
  static std::pair<std::string, int> RunProgram(const std::string& arguments) {
    std::string out;
    FILE* pipe = popen((std::string(TACT_CHECK_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
    for (int c; (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
    return {out, WEXITSTATUS(pclose(pipe))};
  }

  const std::string test_ = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path folder_ =
      fs::temp_directory_path() / ("tact_check_" + test_ + "_" + std::to_string(getpid()));
};

const json kBasisClaim = {{"id", "example.basis"},
                          {"verdict", "proved"},
                          {"seconds", 0.25},
                          {"certificates", {"certificates/b.json"}}};

TEST_F(FolderCheck, AReportWithItsCertificatesIsAccepted) {
  Write("certificates/b.json", brute::Text("basis"));
  fs::create_directories(folder_ / "certificates/more");
  Write("certificates/more/c.json", brute::Text("census"));
  WriteLedger(
      {kBasisClaim,
       {{"id", "example.census"}, {"verdict", "holds to n"}, {"certificates", {"certificates/more/c.json"}}},
       {{"id", "measured"}, {"verdict", "reproduced"}},
       {{"id", "by-hand"}, {"verdict", "refuted"}, {"no_certificate", "the counterexample is a drawing"}}});
  const Report report = Check();
  EXPECT_EQ(report.accepted, 2u);
  EXPECT_TRUE(report.refused.empty()) << report.refused[0].why;
  EXPECT_TRUE(report.unreadable.empty());
}

TEST_F(FolderCheck, AClaimProvedWithoutCertificateOrReasonIsRefused) {
  Write("certificates/b.json", brute::Text("basis"));
  for (const char* verdict : {"proved", "refuted"}) {
    for (const json& claim :
         {json{{"id", "bare"}, {"verdict", verdict}}, json{{"id", "bare"},
                                                           {"verdict", verdict},
                                                           {"certificates", json::array()},
                                                           {"no_certificate", ""}}}) {
      WriteLedger({kBasisClaim, claim});
      const Report report = Check();
      ASSERT_EQ(report.refused.size(), 1u);
      EXPECT_EQ(report.refused[0].why,
                "claims[1]: the claim \"bare\" is " + std::string(verdict) +
                    " without a certificate and without a \"no_certificate\" that says why");
    }
  }
}

TEST_F(FolderCheck, ACertificateMissingOrAboutAnotherClaimIsRefused) {
  Write("certificates/b.json", brute::Text("basis"));
  Write("b.json", brute::Text("basis"));
  json claims = {kBasisClaim, kBasisClaim, kBasisClaim, kBasisClaim};
  claims[1]["id"] = "other";
  claims[2]["id"] = "missing";
  claims[2]["certificates"] = {"certificates/none.json"};
  claims[3]["id"] = "outside";
  claims[3]["certificates"] = {"b.json"};
  WriteLedger(claims);
  const Report report = Check();
  EXPECT_EQ(report.accepted, 1u);
  ASSERT_EQ(report.refused.size(), 3u);
  EXPECT_EQ(report.refused[0].file, (folder_ / "ledger.json").string());
  EXPECT_EQ(report.refused[0].why,
            "claims[1].certificates[0]: \"certificates/b.json\" is about the claim \"example.basis\", not "
            "\"other\"");
  EXPECT_EQ(report.refused[1].why,
            "claims[2].certificates[0]: there is no certificate \"certificates/none.json\"");
  EXPECT_EQ(report.refused[2].why, "claims[3].certificates[0]: there is no certificate \"b.json\"");
}

TEST_F(FolderCheck, ALedgerThatIsNoneIsRefused) {
  for (const json& claims :
       {json(3), json{{"id", "x"}}, json::array({3}), json{{{"id", "x"}, {"verdict", "maybe"}}},
        json{{{"id", "x"}, {"verdict", "undecided"}}, {{"id", "x"}, {"verdict", "undecided"}}}}) {
    WriteLedger(claims);
    EXPECT_EQ(Check().refused.size(), 1u) << claims;
  }
  Write("ledger.json", "{");
  EXPECT_EQ(Check().refused.size(), 1u);
}

TEST_F(FolderCheck, TheProgramSaysWhatWasRefusedAndExitsWithOne) {
  const std::string good = (folder_ / "certificates/a.json").string(),
                    bad = (folder_ / "certificates/b.json").string();
  Write("certificates/a.json", brute::Text("edge_on_face"));
  EXPECT_EQ(RunProgram(folder_.string()),
            std::make_pair(std::string("1 certificates accepted, 0 refused\n"), 0));
  Write("certificates/b.json", "{}");
  EXPECT_EQ(RunProgram(good + " " + bad),
            std::make_pair(
                bad + ": refused: the key \"format\" is missing\n1 certificates accepted, 1 refused\n", 1));
  const auto [text, status] = RunProgram("--json " + folder_.string());
  EXPECT_EQ(status, 1);
  const json expected = {{"accepted", 1},
                         {"refused", {{{"file", bad}, {"why", "the key \"format\" is missing"}}}},
                         {"not_recounted", json::array()}};
  EXPECT_EQ(json::parse(text), expected);
}

TEST_F(FolderCheck, TheProgramExitsWithTwoOnBadUsageOrUnreadableFiles) {
  EXPECT_EQ(RunProgram("").second, 2);
  EXPECT_EQ(RunProgram("--verbose x.json").second, 2);
  EXPECT_EQ(RunProgram((folder_ / "none.json").string()).second, 2);
  EXPECT_EQ(RunProgram("/dev/zero").second, 2);
  EXPECT_EQ(RunProgram((folder_ / "certificates").string()).second, 2) << "a folder without certificates";
  EXPECT_EQ(RunProgram("--help").second, 0);
  EXPECT_NE(RunProgram("--help").first.find("tact-check report/"), std::string::npos);
}

}  // namespace
}  // namespace tact::check

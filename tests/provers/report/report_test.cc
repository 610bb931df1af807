#include "provers/report/report.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "provers/report/ledger_json.h"
#include "provers/report/page.h"
#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test.
class ReportTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "tact-report-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    base_ = pattern;
  }
  void TearDown() override { fs::remove_all(base_); }

  static std::string Read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void Write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  size_t CountInBase() const { return static_cast<size_t>(std::distance(fs::directory_iterator(base_), {})); }
  std::string Refusal(const fs::path& directory) const {
    std::string asked;
    try {
      CheckReportPlace(directory);
    } catch (const InputError& error) {
      asked = error.what();
    }
    try {
      WriteReport({}, directory);
    } catch (const InputError& error) {
      EXPECT_EQ(asked, error.what());
      return asked;
    }
    return "";
  }

  fs::path base_;
};

LedgerEntry Entry(const std::string& id, Verdict verdict) {
  LedgerEntry entry;
  entry.claim = {id, "Statement of " + id + ".", "2.2.1, Proposition 3", "exhaustive", nullptr};
  entry.outcome.verdict = verdict;
  entry.outcome.bound = "6 contacts";
  entry.outcome.evidence = "First.\n\nSecond, with m < n & \"quotes\".\n\n  x = 1\n  y = 2";
  entry.outcome.numbers = {{"zeta", 12345}, {"alpha", -1}};
  entry.seconds = 0.25;
  return entry;
}

std::vector<LedgerEntry> SomeEntries() {
  std::vector<LedgerEntry> entries = {Entry("thesis.5.1.b", Verdict::kHoldsTo),
                                      Entry("thesis.2.2.1.a", Verdict::kProved),
                                      Entry("c", Verdict::kRefuted)};
  entries[0].claim.source = "5.1";
  entries[1].outcome.certificates = {{"a-1", "{\"format\":\"tact-certificate\"}"}, {"a-2", "{}"}};
  entries[1].outcome.tables = {{"Caption <1>", {"name", "count"}, {{"x & y", "12"}, {"z", "3"}}}};
  entries[1].outcome.figures = {
      {"A \"figure\".", "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0\"/></svg>"}};
  entries[2].outcome.no_certificate = "three numbers that anyone can add";
  return entries;
}

TEST_F(ReportTest, HoldsPageLedgerAndCertificates) {
  WriteReport(SomeEntries(), base_ / "deep" / "report");
  const fs::path report = base_ / "deep" / "report";
  EXPECT_EQ(Read(report / "index.html"), ReportPage(SomeEntries()));
  EXPECT_EQ(Read(report / "ledger.json"), LedgerJson(SomeEntries()));
  EXPECT_EQ(Read(report / "certificates" / "a-1.json"), "{\"format\":\"tact-certificate\"}");
  EXPECT_EQ(Read(report / "certificates" / "a-2.json"), "{}");
  EXPECT_EQ(std::distance(fs::directory_iterator(report), {}), 3);
  EXPECT_EQ(std::distance(fs::directory_iterator(base_ / "deep"), {}), 1);
}

TEST_F(ReportTest, ALaterReportReplacesAnEarlierOneEntirely) {
  WriteReport(SomeEntries(), base_ / "report");
  WriteReport({Entry("thesis.2.1.z", Verdict::kHoldsTo)}, base_ / "report/");
  EXPECT_FALSE(fs::exists(base_ / "report" / "certificates" / "a-1.json"));
  EXPECT_NE(Read(base_ / "report" / "ledger.json").find("thesis.2.1.z"), std::string::npos);
  EXPECT_EQ(CountInBase(), 1u);
}

TEST_F(ReportTest, AnEmptyFolderAndALinkToAReportAreReplaced) {
  fs::create_directory(base_ / "report");
  fs::create_directory_symlink("report", base_ / "link");
  WriteReport({}, base_ / "report");
  WriteReport(SomeEntries(), base_ / "link");
  EXPECT_TRUE(fs::is_symlink(base_ / "link"));
  EXPECT_TRUE(fs::exists(base_ / "report" / "certificates" / "a-1.json"));
}

TEST_F(ReportTest, WhatIsNoReportOfOursIsRefusedAndLeftAlone) {
  fs::create_directory(base_ / "photos");
  Write(base_ / "photos" / "cat.jpg", "cat");
  EXPECT_NE(Refusal(base_ / "photos").find("got a folder without ledger.json"), std::string::npos);
  EXPECT_EQ(Read(base_ / "photos" / "cat.jpg"), "cat");

  fs::create_directory(base_ / "books");
  Write(base_ / "books" / "ledger.json", "{\"claims\":[]}");
  EXPECT_NE(Refusal(base_ / "books").find("ledger.json is not tact's"), std::string::npos);

  WriteReport({}, base_ / "report");
  Write(base_ / "report" / "notes.txt", "mine");
  EXPECT_NE(Refusal(base_ / "report").find("something else in it: notes.txt"), std::string::npos);
  EXPECT_EQ(Read(base_ / "report" / "notes.txt"), "mine");

  Write(base_ / "file", "x");
  EXPECT_NE(Refusal(base_ / "file").find("no folder"), std::string::npos);
  EXPECT_NE(Refusal("/").find("root of the file system"), std::string::npos);
  EXPECT_NE(Refusal(base_ / "file" / "report").find("file: expected a folder to write the report in"),
            std::string::npos);
}

TEST_F(ReportTest, AWriteThatFailsHalfWayLeavesTheOldReportAndNothingElse) {
  WriteReport(SomeEntries(), base_ / "report");
  std::vector<LedgerEntry> entries = {Entry("thesis.2.1.z", Verdict::kProved)};
  entries[0].outcome.certificates = {{"fine", "{}"}, {"no-such-folder/name", "{}"}};
  EXPECT_THROW(WriteReport(entries, base_ / "report"), InputError);
  EXPECT_EQ(Read(base_ / "report" / "ledger.json"), LedgerJson(SomeEntries()));
  EXPECT_FALSE(fs::exists(base_ / "report" / "certificates" / "fine.json"));
  EXPECT_EQ(CountInBase(), 1u);
}

TEST_F(ReportTest, AKilledWriteLeavesAWholeReport) {
  std::vector<LedgerEntry> entries = {Entry("thesis.2.1.z", Verdict::kProved)};
  for (int i = 0; i < 60; ++i) entries[0].outcome.certificates.push_back({"z-" + std::to_string(i), "{}"});
  WriteReport(SomeEntries(), base_ / "report");
  int old_ones = 0;
  for (int round = 0; round < 20; ++round) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (bool odd = true;; odd = !odd) WriteReport(odd ? entries : SomeEntries(), base_ / "report");
    }
    usleep(static_cast<useconds_t>(700 + 390 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const bool old = Read(base_ / "report" / "ledger.json") == LedgerJson(SomeEntries());
    old_ones += old;
    const auto& expected = old ? SomeEntries() : entries;
    EXPECT_EQ(Read(base_ / "report" / "ledger.json"), LedgerJson(expected));
    EXPECT_EQ(Read(base_ / "report" / "index.html"), ReportPage(expected));
    EXPECT_EQ(std::distance(fs::directory_iterator(base_ / "report" / "certificates"), {}), old ? 2 : 60);
  }
  RecordProperty("old", old_ones);
}

TEST(LedgerJson, HasTheSchemaOfTheDesign) {
  const auto ledger = nlohmann::json::parse(LedgerJson(SomeEntries()));
  EXPECT_EQ(ledger.at("format"), "tact-ledger");
  ASSERT_EQ(ledger.at("claims").size(), 3u);
  const auto& proved = ledger.at("claims").at(1);
  EXPECT_EQ(proved.at("id"), "thesis.2.2.1.a");
  EXPECT_EQ(proved.at("statement"), "Statement of thesis.2.2.1.a.");
  EXPECT_EQ(proved.at("source"), "2.2.1, Proposition 3");
  EXPECT_EQ(proved.at("method"), "exhaustive");
  EXPECT_EQ(proved.at("bound"), "6 contacts");
  EXPECT_EQ(proved.at("verdict"), "proved");
  EXPECT_EQ(proved.at("evidence"), "First.\n\nSecond, with m < n & \"quotes\".\n\n  x = 1\n  y = 2");
  EXPECT_EQ(proved.at("numbers"), (nlohmann::json{{"zeta", 12345}, {"alpha", -1}}));
  EXPECT_EQ(proved.at("certificates"), (nlohmann::json{"certificates/a-1.json", "certificates/a-2.json"}));
  EXPECT_EQ(proved.at("seconds"), 0.25);
  EXPECT_FALSE(proved.contains("no_certificate"));
  EXPECT_EQ(ledger.at("claims").at(2).at("no_certificate"), "three numbers that anyone can add");
  EXPECT_FALSE(ledger.at("claims").at(0).contains("no_certificate"));
}

TEST(LedgerJson, OnlyLinesWithSecondsDependOnTheClock) {
  auto slow = SomeEntries();
  for (LedgerEntry& entry : slow) entry.seconds = 17.125;
  std::istringstream a(LedgerJson(SomeEntries())), b(LedgerJson(slow));
  std::string line_a, line_b;
  int differing = 0;
  while (std::getline(a, line_a)) {
    ASSERT_TRUE(std::getline(b, line_b));
    if (line_a == line_b) continue;
    ++differing;
    EXPECT_NE(line_a.find("\"seconds\": 0.25"), std::string::npos);
  }
  EXPECT_EQ(differing, 3);
}

TEST(LedgerJson, BytesThatAreNoUtf8DoNotStopIt) {
  auto entries = SomeEntries();
  entries[0].outcome.evidence = "file \xff\xfe";
  EXPECT_EQ(nlohmann::json::parse(LedgerJson(entries)).at("claims").at(0).at("evidence"),
            "file \uFFFD\uFFFD");
}

TEST(Page, IsWellFormedAndLinksOnlyToItselfAndItsCertificates) {
  auto entries = SomeEntries();
  entries[2].claim.id = "odd <id> & \"quotes\"";
  entries[2].outcome.evidence = std::string("\x01\xff </article><script>alert(1)</script>");
  const XmlContents page = ReadXml(ReportPage(entries));
  EXPECT_EQ(page.error, "");
  for (const std::string& link : page.links) {
    const bool inside = link.starts_with("#") && page.ids.count(link.substr(1)) == 1;
    EXPECT_TRUE(inside || link == "certificates/a-1.json" || link == "certificates/a-2.json") << link;
  }
  EXPECT_EQ(page.elements.at("article"), 3);
  EXPECT_EQ(page.elements.at("script"), 1);
  EXPECT_EQ(page.elements.at("svg"), 1);
  EXPECT_EQ(page.elements.at("pre"), 2);
  EXPECT_NE(page.text.find("</article><script>alert(1)</script>"), std::string::npos);
}

TEST(Page, SaysEverythingAboutAClaim) {
  const std::string text = ReadXml(ReportPage(SomeEntries())).text;
  for (const char* expected :
       {"Statement of thesis.2.2.1.a.", "2.2.1, Proposition 3", "exhaustive", "6 contacts", "250 ms",
        "Second, with m < n & \"quotes\".", "  x = 1\n  y = 2", "12\u202F345", "Caption <1>", "x & y",
        "A \"figure\".", "three numbers that anyone can add",
        "Chapter 2: ", "2.2 Indexing infinitesimal displacement", "3 claims"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected;
  }
}

TEST(Page, FollowsTheThesisAndCountsTheVerdicts) {
  const std::string page = ReportPage(SomeEntries());
  const size_t contents = page.find("<nav"), claims = page.find("<main");
  for (const size_t from : {contents, claims}) {
    const size_t second = page.find("Chapter 2", from), fifth = page.find("Chapter 5", from);
    EXPECT_LT(second, page.find("thesis.2.2.1.a", from));
    EXPECT_LT(page.find("thesis.2.2.1.a", from), fifth);
    EXPECT_LT(fifth, page.find("thesis.5.1.b", from));
  }
  EXPECT_EQ(ReadXml(page).elements.at("h2"), 3);  // contents and two chapters: "c" stands in 2.2.1
  for (const Verdict verdict : {Verdict::kProved, Verdict::kHoldsTo, Verdict::kRefuted}) {
    EXPECT_NE(page.find("<li><b>1</b> " + VerdictChip(verdict)), std::string::npos);
  }
  EXPECT_EQ(page.find("<li><b>0</b>"), std::string::npos);
}

TEST(Page, WithoutClaimsIsAPageToo) {
  const XmlContents page = ReadXml(ReportPage({}));
  EXPECT_EQ(page.error, "");
  EXPECT_NE(page.text.find("No claim was tried."), std::string::npos);
}

TEST(XmlCheck, RefusesWhatIsNotWellFormed) {
  EXPECT_EQ(ReadXml("<a b=\"1\"><c/>x &amp; y</a>").error, "");
  for (const char* bad : {"<a>", "<a></b>", "<a>&nbsp;</a>", "<a b=1/>", "<a b=\"1\" b=\"2\"/>", "<a/><b/>",
                          "<a>x & y</a>", "<a id=\"i\"><b id=\"i\"/></a>", "<a b=\"<\"/>", "x", ""}) {
    EXPECT_NE(ReadXml(bad).error, "") << bad;
  }
}

}  // namespace
}  // namespace tact::provers

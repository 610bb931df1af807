#include "provers/ledger.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <atomic>
#include <chrono>
#include <regex>
#include <thread>

#include "algebra/error.h"

namespace tact::provers {
namespace {

Claim ClaimOf(const std::string& id, std::function<Outcome(Effort)> run) {
  return {id, "A statement.", "2.2.1", "exhaustive", std::move(run)};
}

Outcome HoldsTo(long long bound) {
  Outcome outcome;
  outcome.verdict = Verdict::kHoldsTo;
  outcome.numbers = {{"cases", bound}};
  return outcome;
}

std::string Evidence(const Outcome& outcome) {
  return TryClaims({ClaimOf("a", [outcome](Effort) { return outcome; })}, Effort::kQuick)
      .at(0)
      .outcome.evidence;
}

TEST(Ledger, VerdictsHaveTheWordsOfTheDesign) {
  EXPECT_EQ(ToString(Verdict::kProved), "proved");
  EXPECT_EQ(ToString(Verdict::kHoldsTo), "holds to n");
  EXPECT_EQ(ToString(Verdict::kRefuted), "refuted");
  EXPECT_EQ(ToString(Verdict::kReproduced), "reproduced");
  EXPECT_EQ(ToString(Verdict::kNotReproduced), "not reproduced");
  EXPECT_EQ(ToString(Verdict::kUndecided), "undecided");
}

TEST(Ledger, EntriesComeInTheOrderOfTheClaimsWhicheverIsDoneFirst) {
  std::vector<Claim> claims;
  for (int i = 0; i < 12; ++i) {
    claims.push_back(ClaimOf("claim-" + std::to_string(i), [i](Effort) {
      std::this_thread::sleep_for(std::chrono::milliseconds(12 - i));
      return HoldsTo(i);
    }));
  }
  for (const int threads : {1, 4, 40}) {
    const auto entries = TryClaims(claims, Effort::kQuick, {}, {}, threads);
    ASSERT_EQ(entries.size(), claims.size());
    for (int i = 0; i < 12; ++i) {
      EXPECT_EQ(entries[i].claim.id, "claim-" + std::to_string(i));
      EXPECT_EQ(entries[i].outcome.numbers.at(0).second, i);
      EXPECT_GE(entries[i].seconds, 0.001 * (12 - i));
    }
  }
}

TEST(Ledger, ClaimsRunAtTheSameTimeOnSeveralThreads) {
  // Each of two claims waits for the other to have begun.
  std::atomic<int> begun = 0;
  const auto meet = [&begun](Effort) {
    ++begun;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (begun < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return HoldsTo(begun);
  };
  const auto entries = TryClaims({ClaimOf("a", meet), ClaimOf("b", meet)}, Effort::kQuick, {}, {}, 2);
  EXPECT_EQ(entries[0].outcome.numbers.at(0).second, 2);
}

TEST(Ledger, AClaimThatThrowsIsUndecidedAndTheOthersGoOn) {
  const std::vector<Claim> claims = {
      ClaimOf("bug", [](Effort) -> Outcome { throw InvariantError("rank exceeds six"); }),
      ClaimOf("file", [](Effort) -> Outcome { throw InputError("peg.off:3: expected a number, got x"); }),
      ClaimOf("int", [](Effort) -> Outcome { throw 7; }),
      ClaimOf("fine", [](Effort) { return HoldsTo(1); }),
  };
  const auto entries = TryClaims(claims, Effort::kQuick, {}, {}, 2);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(entries[i].outcome.verdict, Verdict::kUndecided);
  EXPECT_EQ(entries[0].outcome.evidence, "The trial broke off on an error of tact itself: rank exceeds six");
  EXPECT_EQ(entries[1].outcome.evidence, "The trial broke off: peg.off:3: expected a number, got x");
  EXPECT_NE(entries[2].outcome.evidence.find("no std::exception"), std::string::npos);
  EXPECT_EQ(entries[3].outcome.verdict, Verdict::kHoldsTo);
}

TEST(Ledger, EffortReachesTheClaim) {
  const auto claim = ClaimOf("a", [](Effort effort) { return HoldsTo(effort == Effort::kFull ? 9 : 3); });
  EXPECT_EQ(TryClaims({claim}, Effort::kFull).at(0).outcome.numbers.at(0).second, 9);
  EXPECT_EQ(TryClaims({claim}, Effort::kQuick).at(0).outcome.numbers.at(0).second, 3);
}

TEST(Ledger, OnlySelectsByGlobInClaimOrder) {
  const auto run = [](Effort) { return HoldsTo(1); };
  const std::vector<Claim> claims = {ClaimOf("thesis.2.1.a", run), ClaimOf("thesis.5.1.b", run),
                                     ClaimOf("thesis.5.2.c", run)};
  const auto entries = TryClaims(claims, Effort::kQuick, {"thesis.5.2.?", "thesis.2*", "*2.c"});
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].claim.id, "thesis.2.1.a");
  EXPECT_EQ(entries[1].claim.id, "thesis.5.2.c");
}

TEST(Ledger, OnlyThatMatchesNothingIsRefusedWithTheIds) {
  const auto run = [](Effort) { return HoldsTo(1); };
  try {
    TryClaims({ClaimOf("thesis.a", run), ClaimOf("thesis.b", run)}, Effort::kQuick, {"*", "thesis.c"});
    FAIL() << "expected InputError";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'thesis.c'"), std::string::npos);
    EXPECT_NE(message.find("\n  thesis.a\n  thesis.b"), std::string::npos);
  }
}

TEST(Ledger, ClaimsWithOneIdOrWithoutRunAreRefused) {
  const auto run = [](Effort) { return HoldsTo(1); };
  EXPECT_THROW(TryClaims({ClaimOf("a", run), ClaimOf("a", run)}, Effort::kQuick), PreconditionError);
  EXPECT_THROW(TryClaims({ClaimOf("", run)}, Effort::kQuick), PreconditionError);
  EXPECT_THROW(TryClaims({ClaimOf("a", nullptr)}, Effort::kQuick), PreconditionError);
}

TEST(Ledger, ProgressTellsOfEachClaimOnce) {
  std::vector<Claim> claims;
  for (int i = 0; i < 20; ++i)
    claims.push_back(ClaimOf(std::to_string(i), [i](Effort) { return HoldsTo(i); }));
  std::vector<int> told(20, 0);
  size_t expected = 0;
  TryClaims(
      claims, Effort::kQuick, {},
      [&](const LedgerEntry& entry, size_t done, size_t total) {
        EXPECT_EQ(done, ++expected);
        EXPECT_EQ(total, 20u);
        EXPECT_EQ(std::to_string(entry.outcome.numbers.at(0).second), entry.claim.id);
        ++told.at(std::stoul(entry.claim.id));
      },
      4);
  EXPECT_EQ(told, std::vector<int>(20, 1));
}

TEST(Ledger, AnOutcomeThatBreaksItsRulesIsUndecidedAndNamesTheRule) {
  Outcome good;
  good.verdict = Verdict::kProved;
  good.evidence = "It does.";
  good.certificates = {{"a-1", "{}"}};
  good.tables = {{"t", {"x", "y"}, {{"1", "2"}}}};
  good.figures = {{"f", "<svg></svg>"}};
  EXPECT_EQ(Evidence(good), "It does.");

  Outcome bad = good;
  bad.certificates.clear();
  EXPECT_NE(Evidence(bad).find("neither"), std::string::npos);
  bad.no_certificate = "a sum of six numbers";
  EXPECT_EQ(Evidence(bad), "It does.");
  bad = good;
  bad.tables[0].rows.push_back({"3"});
  EXPECT_NE(Evidence(bad).find("rows of 2 cells"), std::string::npos);
  for (const char* name : {"../a", "a/b", "", "a b", ".hidden"}) {
    bad = good;
    bad.certificates[0].name = name;
    EXPECT_NE(Evidence(bad).find("expected a certificate named with"), std::string::npos) << name;
  }
  bad = good;
  bad.certificates.push_back(bad.certificates[0]);
  EXPECT_NE(Evidence(bad).find("'a-1' twice"), std::string::npos);
  bad = good;
  bad.certificates[0].json = "{";
  EXPECT_NE(Evidence(bad).find("no JSON"), std::string::npos);
  bad = good;
  bad.figures[0].svg = "<p></p>";
  EXPECT_NE(Evidence(bad).find("one <svg>"), std::string::npos);
  bad = good;
  bad.numbers = {{"n", 1}, {"n", 2}};
  EXPECT_NE(Evidence(bad).find("'n' twice"), std::string::npos);
}

TEST(Ledger, OfTwoClaimsWithOneCertificateNameTheLaterIsUndecided) {
  const auto proof = [](int milliseconds) {
    return [milliseconds](Effort) {
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      Outcome outcome;
      outcome.verdict = Verdict::kProved;
      outcome.certificates = {{"same", "{}"}};
      return outcome;
    };
  };
  const auto entries =
      TryClaims({ClaimOf("slow", proof(20)), ClaimOf("fast", proof(0))}, Effort::kQuick, {}, {}, 2);
  EXPECT_EQ(entries[0].outcome.verdict, Verdict::kProved);
  EXPECT_EQ(entries[1].outcome.verdict, Verdict::kUndecided);
  EXPECT_NE(entries[1].outcome.evidence.find("slow"), std::string::npos);
}

RC_GTEST_PROP(GlobLaw, AgreesWithRegularExpressions, ()) {
  const auto pattern = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '.', '*', '?'));
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '.'));
  std::string expression;
  for (const char c : pattern)
    expression += c == '*' ? ".*" : c == '?' ? "." : c == '.' ? "\\." : std::string(1, c);
  RC_ASSERT(GlobMatches(pattern, text) == std::regex_match(text, std::regex(expression)));
}

}  // namespace
}  // namespace tact::provers

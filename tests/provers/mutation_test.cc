// Every certificate of the report, with one number changed, in a formula too: tact-check accepts it just if it is still right.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <set>

#include "provers/check/check.h"
#include "provers/claims/claims.h"
#include "tests/provers/certificate_oracle.h"
#include "tests/provers/ledger_once.h"

namespace tact::provers {
namespace {

using nlohmann::json;

constexpr size_t kWanted = 10000;  // mutations that make a certificate wrong
constexpr unsigned kSeed = 20060329;

// A long list that stands under several claims is tried once.
std::vector<std::pair<std::string, json>> CertificatesOf(Effort effort) {
  std::vector<std::pair<std::string, json>> all;
  std::set<std::string> lists;
  for (const LedgerEntry& entry : LedgerOnce(effort)) {
    for (const Certificate& certificate : entry.outcome.certificates) {
      json parsed = json::parse(certificate.json);
      const bool again = parsed["kind"] == "dof-classes" && !lists.insert(parsed["classes"].dump()).second;
      if (!again) all.emplace_back(certificate.name, std::move(parsed));
    }
  }
  return all;
}

// Where a number stands: the whole value, or digits of a formula.
struct Place {
  json::json_pointer value;
  size_t start = 0, length = 0;  // of the digits; none for the whole value
};

// The numbers of a text, those of a name (x12) left out.
std::vector<std::pair<size_t, size_t>> NumbersIn(const std::string& formula) {
  std::vector<std::pair<size_t, size_t>> numbers;
  for (size_t at = 0; at < formula.size();) {
    size_t end = at;
    while (end < formula.size() && std::isalnum(static_cast<unsigned char>(formula[end]))) ++end;
    if (end > at && std::isdigit(static_cast<unsigned char>(formula[at]))) numbers.emplace_back(at, end - at);
    at = std::max(end, at + 1);
  }
  return numbers;
}

// The integers of a certificate by what they are: `/classes/relation/all/y` and the like, list places left out.
using Kinds = std::map<std::string, std::vector<Place>>;
Kinds KindsOfNumbers(const json& certificate) {
  Kinds kinds;
  const bool has_formulas = certificate["kind"] == "identity" || certificate["kind"] == "no-identity";
  const json flat = certificate.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (!value.is_number_integer() && !(has_formulas && value.is_string())) continue;
    if (path == "/claim" || path == "/format" || path == "/kind") continue;
    std::string kind, part;
    std::istringstream parts(path);
    while (std::getline(parts, part, '/')) {
      if (!part.empty() && part.find_first_not_of("0123456789") != part.npos) kind += "/" + part;
    }
    const json::json_pointer at(path);
    if (value.is_number_integer()) {
      kinds[kind].push_back({at});
    } else {
      for (const auto& [start, length] : NumbersIn(value)) kinds[kind].push_back({at, start, length});
    }
  }
  std::erase_if(kinds, [](const auto& kind) { return kind.second.empty(); });
  return kinds;
}

template <typename Random>
long long Mutate(long long n, Random& random) {
  const auto pick = [&](long long from, long long to) {
    return std::uniform_int_distribution<long long>(from, to)(random);
  };
  switch (pick(0, 7)) {
    case 0:
      return n + 1;
    case 1:
      return n - 1;
    case 2:
      return n + pick(2, 9);
    case 3:
      return n - pick(2, 9);
    case 4:
      return -n;
    case 5:
      return 0;
    case 6:
      return 2 * n;
    default:
      return pick(-20, 20);
  }
}

long long NumberAt(const json& certificate, const Place& place) {
  const json& value = certificate.at(place.value);
  return place.length == 0 ? value.get<long long>()
                           : std::stoll(value.get<std::string>().substr(place.start, place.length));
}

json WithNumber(json certificate, const Place& place, long long number) {
  json& value = certificate.at(place.value);
  if (place.length == 0) {
    value = number;
  } else {
    value = value.get<std::string>().replace(place.start, place.length, std::to_string(number));
  }
  return certificate;
}

struct Tally {
  size_t wrong = 0, harmless = 0;
};

// Draws until kWanted different mutations have been wrong ones.
void TryMutations(Effort effort) {
  const auto certificates = CertificatesOf(effort);
  std::vector<Kinds> kinds;
  for (const auto& [name, certificate] : certificates) kinds.push_back(KindsOfNumbers(certificate));
  std::mt19937_64 random(kSeed);
  std::set<std::tuple<size_t, std::string, size_t, long long>> seen;
  std::map<std::string, Tally> tallies;
  Tally total;
  for (size_t draw = 0; total.wrong < kWanted; ++draw) {
    ASSERT_LT(draw, 100 * kWanted) << "the certificates have too few numbers";
    const size_t i = draw % certificates.size();
    const auto& [name, original] = certificates[i];
    const auto& [kind, places] = *std::next(kinds[i].begin(), static_cast<long>(random() % kinds[i].size()));
    const Place& place = places[random() % places.size()];
    const std::string where = place.value.to_string();
    const long long before = NumberAt(original, place), after = Mutate(before, random);
    if (after == before || !seen.emplace(i, where, place.start, after).second) continue;

    const json mutant = WithNumber(original, place, after);
    const bool right = oracle::IsRight(mutant);
    const check::Answer answer = check::CheckCertificate(mutant.dump());
    ASSERT_EQ(answer.accepted, right)
        << name << ", " << where << ": " << before << " -> " << after
        << "\ntact-check says: " << (answer.accepted ? "accepted" : answer.why) << "\n"
        << mutant.dump(1);
    ASSERT_EQ(answer.not_recounted, "") << name << ", " << where;
    ++(right ? total.harmless : total.wrong);
    const std::string group = original["kind"].get<std::string>() + " " + kind;
    ++(right ? tallies[group].harmless : tallies[group].wrong);
  }
  std::cout << total.wrong << " mutations that make a certificate wrong: all refused; " << total.harmless
            << " that leave it right: all accepted\n";
  for (const auto& [group, tally] : tallies)
    std::cout << "  " << group << ": " << tally.wrong << " wrong, " << tally.harmless << " right\n";
  for (const char* touched : {"basis /vectors",
                              "basis /reduced",
                              "basis /translations",
                              "census /count",
                              "census /classes/count",
                              "census /generator/contacts/point",
                              "census /generator/contacts/planes",
                              "census /generator/largest",
                              "census /asserts/sum/constant",
                              "dof-classes /classes/contacts/planes",
                              "dof-classes /counts/classes",
                              "census /classes/relation/all/x",
                              "census /classes/relation/all/y",
                              "ill-reduced-singular /motion",
                              "ill-reduced-singular /between",
                              "identity /equations/left",
                              "identity /equations/right",
                              "no-identity /left",
                              "knot-tying /p_data/sigma",
                              "knot-tying /p_data/attr",
                              "knot-tying /moves/segments",
                              "motion-dofs /relation/contacts/point",
                              "motion-dofs /relation/contacts/planes",
                              "motion-dofs /relation/dof/all/maintaining",
                              "knot-move /before/sigma",
                              "knot-move /after/attr",
                              "knot-move /move/segments",
                              "knot-move /move/attr",
                              "knot-rule /before/sigma",
                              "knot-rule /after/attr",
                              "knot-rule /misses/segments",
                              "transitions /transitions/from",
                              "transitions /transitions/to",
                              "transitions /expects/changes/translation.maintaining"}) {
    EXPECT_GT(tallies[touched].wrong, 0u) << touched;
  }
}

void ExpectAllAccepted(Effort effort) {
  const auto certificates = CertificatesOf(effort);
  EXPECT_GE(certificates.size(), 20u);
  for (const auto& [name, certificate] : certificates) {
    const check::Answer answer = check::CheckCertificate(certificate.dump());
    EXPECT_TRUE(answer.accepted) << name << ": " << answer.why;
    EXPECT_EQ(answer.not_recounted, "") << name;
    EXPECT_TRUE(oracle::IsRight(certificate)) << name;
  }
}

TEST(ReportMutation, EveryCertificateOfTheQuickReportIsAcceptedAndRight) {
  ExpectAllAccepted(Effort::kQuick);
}
TEST(FullReportMutation, EveryCertificateOfTheReportIsAcceptedAndRight) {
  ExpectAllAccepted(Effort::kStandard);
}

TEST(ReportMutation, OneChangedNumberIsRefusedJustIfTheCertificateIsWrongThen) {
  TryMutations(Effort::kQuick);
}
TEST(FullReportMutation, OneChangedNumberIsRefusedJustIfTheCertificateIsWrongThen) {
  TryMutations(Effort::kStandard);
}

}  // namespace
}  // namespace tact::provers

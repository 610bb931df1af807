// Changes to accepted certificates. Whether a changed number leaves the certificate right is decided by brute
// force.
#include <gtest/gtest.h>

#include "provers/check/check.h"
#include "tests/check/brute.h"

namespace tact::check {
namespace {

using brute::json;

bool Accepts(const json& certificate) { return CheckCertificate(certificate.dump()).accepted; }

std::vector<json::json_pointer> Leaves(const json& certificate) {
  std::vector<json::json_pointer> leaves;
  const json flat = certificate.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (!value.is_null()) leaves.emplace_back(path);
  }
  return leaves;
}

// Every object and list, the whole included.
std::vector<json::json_pointer> Containers(const json& certificate,
                                           const json::json_pointer& at = json::json_pointer()) {
  std::vector<json::json_pointer> all = {at};
  const json& here = certificate.at(at);
  for (const auto& [key, value] : here.items()) {
    if (!value.is_structured()) continue;
    const auto below = Containers(certificate, here.is_array() ? at / std::stoul(key) : at / key);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

// With the numbers of a transition list itself (from, to, changes) always counted as wrong: in these examples
// no change of them is right again.
bool IsRight(const json& c, const json::json_pointer& changed) {
  if (changed.to_string() == "/version") return false;
  const std::string kind = c["kind"];
  if (kind == "motion-dofs") {
    return brute::RelationIsRight(c["relation"]) && brute::AssertsHold(c, c["relation"]["dof"]);
  }
  if (kind == "census") {
    long long members = 0;
    for (const json& one : c["classes"]) {
      if (one["count"] <= 0 || !brute::RelationIsRight(one["relation"])) return false;
      if (!brute::AssertsHold(c, one["relation"]["dof"])) return false;
      members += one["count"].get<long long>();
    }
    return members == c["count"];
  }
  if (kind == "transitions") {
    for (const json& relation : c["relations"]) {
      if (!brute::RelationIsRight(relation)) return false;
    }
    return changed.to_string().starts_with("/relations");
  }
  return kind == "basis" ? brute::BasisIsRight(c) : brute::IllReducedIsRight(c);
}

class NumberMutation : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Check, NumberMutation, testing::ValuesIn(brute::kAll),
                         [](const auto& one) { return one.param; });

class Mutation : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Check, Mutation, testing::ValuesIn(brute::kAllAndPaths),
                         [](const auto& one) { return one.param; });

TEST_P(Mutation, TheHandMadeCertificateIsAccepted) {
  const Answer answer = CheckCertificate(brute::Text(GetParam()));
  EXPECT_TRUE(answer.accepted) << answer.why;
}

TEST_P(NumberMutation, AChangedNumberIsRefusedUnlessBruteForceFindsTheCertificateStillRight) {
  const json original = brute::Certificate(GetParam());
  int refused = 0;
  for (const auto& leaf : Leaves(original)) {
    if (!original.at(leaf).is_number()) continue;
    const long long n = original.at(leaf);
    for (const long long changed : {n + 1, n - 1, -n, 0LL}) {
      if (changed == n) continue;
      json mutant = original;
      mutant.at(leaf) = changed;
      const bool right = IsRight(mutant, leaf);
      EXPECT_EQ(Accepts(mutant), right) << leaf.to_string() << ": " << n << " -> " << changed;
      refused += !right;
    }
  }
  EXPECT_GT(refused, 10);
}

TEST_P(Mutation, EveryDofAndCountIsCheckedWhateverItIsChangedTo) {
  const json original = brute::Certificate(GetParam());
  for (const auto& leaf : Leaves(original)) {
    const std::string path = leaf.to_string();
    if (!original.at(leaf).is_number()) continue;
    if (path.find("/dof/") == path.npos && !path.ends_with("/count") && !path.ends_with("/translations"))
      continue;
    const long long n = original.at(leaf);
    for (const json& changed :
         {json(n + 1), json(n - 1), json(n + (1LL << 32)), json(std::to_string(n) + "000000000000000001"),
          json(-n - 1), json(n + 0.5), json(true), json(nullptr), json("")}) {
      json mutant = original;
      mutant.at(leaf) = changed;
      EXPECT_FALSE(Accepts(mutant)) << path << " -> " << changed;
    }
  }
}

TEST_P(Mutation, ANumberThatIsNoIntegerIsRefusedEverywhere) {
  const json original = brute::Certificate(GetParam());
  for (const auto& leaf : Leaves(original)) {
    if (!original.at(leaf).is_number()) continue;
    const std::string n = original.at(leaf).dump();
    for (const json& changed :
         {json(original.at(leaf).get<double>()), json(n + ".0"), json("0" + n), json(" " + n), json(n + "e0"),
          json("+" + n), json::array({original.at(leaf)})}) {
      json mutant = original;
      mutant.at(leaf) = changed;
      EXPECT_FALSE(Accepts(mutant)) << leaf.to_string() << " -> " << changed;
    }
    json same = original;
    same.at(leaf) = n;
    EXPECT_TRUE(Accepts(same)) << leaf.to_string() << " as a string of digits";
  }
}

TEST_P(Mutation, AFlippedFlagOrAChangedWordWithMeaningIsRefused) {
  const json original = brute::Certificate(GetParam());
  for (const auto& leaf : Leaves(original)) {
    const std::string path = leaf.to_string();
    json mutant = original;
    if (original.at(leaf).is_boolean()) {
      mutant.at(leaf) = !original.at(leaf).get<bool>();
    } else if (original.at(leaf).is_string()) {
      const bool prose =
          path == "/statement" || path == "/world" || path == "/claim" || path.starts_with("/names/");
      mutant.at(leaf) = prose ? json(1) : json(original.at(leaf).get<std::string>() + "s");
    } else {
      continue;
    }
    EXPECT_FALSE(Accepts(mutant)) << path;
  }
}

TEST_P(Mutation, AnUnknownKeyAnywhereIsRefused) {
  const json original = brute::Certificate(GetParam());
  for (const auto& place : Containers(original)) {
    if (!original.at(place).is_object()) continue;
    for (const char* key : {"comment", "", "x ", "singular_restricted"}) {
      json mutant = original;
      mutant.at(place)[key] = 0;
      EXPECT_FALSE(Accepts(mutant)) << place.to_string() << " with " << key;
    }
  }
}

TEST_P(Mutation, AMissingKeyIsRefusedUnlessOptional) {
  const json original = brute::Certificate(GetParam());
  for (const auto& place : Containers(original)) {
    const std::string path = place.to_string();
    if (!original.at(place).is_object() || path.ends_with("/sum") || path.ends_with("/changes")) continue;
    for (const auto& [key, value] : original.at(place).items()) {
      const bool optional = key == "statement" || key == "asserts" || key == "expects" || key == "name";
      json mutant = original;
      mutant.at(place).erase(key);
      EXPECT_EQ(Accepts(mutant), optional) << path << " without " << key;
    }
  }
}

TEST_P(Mutation, AListOfNumbersOneShorterOrLongerIsRefused) {
  const json original = brute::Certificate(GetParam());
  for (const auto& place : Containers(original)) {
    const json& list = original.at(place);
    if (!list.is_array() || (!list.empty() && !list[0].is_number())) continue;
    json longer = original, shorter = original;
    longer.at(place).push_back(0);
    EXPECT_FALSE(Accepts(longer)) << place.to_string();
    if (list.empty()) continue;
    shorter.at(place).erase(list.size() - 1);
    EXPECT_FALSE(Accepts(shorter)) << place.to_string();
  }
}

TEST_P(Mutation, ATruncatedTextIsRefused) {
  std::string text = brute::Certificate(GetParam()).dump();
  EXPECT_TRUE(CheckCertificate(text).accepted);
  while (!text.empty()) {
    text.pop_back();
    const Answer answer = CheckCertificate(text);
    ASSERT_FALSE(answer.accepted) << text;
    ASSERT_FALSE(answer.why.empty());
  }
}

}  // namespace
}  // namespace tact::check

// A census that names its generator: the world is counted, and counted again.
#include <gtest/gtest.h>

#include "provers/check/check.h"
#include "provers/check/recount.h"
#include "tests/check/brute.h"

namespace tact::check {
namespace {

using brute::json;

json Contact(int x, int normal) {
  return {{"point", {x, 0, 0, 1}}, {"planes", json::array({{0, 0, normal}})}};
}

// At most two contacts of a floor at 0 and a ceiling at x: none; floor, ceiling, each twice; both.
json World() {
  json census = brute::Certificate("census");
  census.erase("asserts");
  census["world"] = "a floor, a ceiling";
  census["count"] = 6;
  json one = census["classes"][0];
  one["count"] = 4;
  json& relation = one["relation"];
  relation["contacts"] = json::array({Contact(0, 1)});
  relation["all"] = {{"x", {0, 0, 0, 0, 0, 1}}, {"y", {0}}};
  relation["translation"] = {{"x", {0, 0, 1}}, {"y", {0}}};
  relation["dof"] = brute::DofOf(relation["contacts"], relation["all"], relation["translation"]);
  const json both = {{"count", 1}, {"relation", brute::Certificate("opposed_points")["relation"]}};
  census["classes"] = json::array({census["classes"][0], one, both});
  census["generator"] = {{"contacts", json::array({Contact(0, 1), Contact(1, -1)})}, {"largest", 2}};
  return census;
}

Answer Check(const json& certificate) { return CheckCertificate(certificate.dump()); }

TEST(CensusWorld, ARightCensusIsAcceptedAndRecounted) {
  const Answer answer = Check(World());
  EXPECT_TRUE(answer.accepted) << answer.why;
  EXPECT_EQ(answer.not_recounted, "");
}

TEST(CensusWorld, AMemberPutIntoAnotherClassIsFoundByTheRecount) {
  json census = World();
  census["classes"][0]["count"] = 2;
  census["classes"][1]["count"] = 3;
  EXPECT_EQ(Check(census).why.substr(0, 17), "classes[1].count:") << Check(census).why;
  EXPECT_NE(Check(census).why.find("the world has 4 such relations"), std::string::npos);
}

TEST(CensusWorld, AnotherNumberOfMultisetsIsRefused) {
  json census = World();
  census["generator"]["largest"] = 3;
  EXPECT_EQ(Check(census).why, "count: the generator makes \"10\" relations");
  census["generator"]["largest"] = 65;
  EXPECT_EQ(Check(census).why, "generator.largest: expected an index from 0 to 65 exclusive");
}

TEST(CensusWorld, AContactTwiceIsRefusedWhateverItsNames) {
  json census = World();
  json again = Contact(0, 1);
  again["name"] = "another";
  census["generator"]["contacts"].push_back(again);
  EXPECT_EQ(Check(census).why, "generator.contacts[2]: stands twice");
}

TEST(CensusWorld, AWitnessFromOutsideIsRefusedThoughItsDofFit) {
  json census = World();
  census["classes"][1]["relation"]["contacts"][0]["point"] = {0, 0, 3, 1};  // the same row
  EXPECT_EQ(Check(census).why, "classes[1].relation.contacts[0]: is none of the generator's contacts");
  census = World();
  census["generator"] = {
      {"contacts", json::array({Contact(0, 1), Contact(1, -1), Contact(2, 1), Contact(3, 1), Contact(4, 1)})},
      {"largest", 1}};
  EXPECT_EQ(Check(census).why,
            "classes[2].relation.contacts: the generator makes relations of at most 1 contacts");
}

TEST(CensusWorld, AWorldThatIsNotRecountedSaysWhy) {
  json census = World();
  census.erase("generator");
  EXPECT_TRUE(Check(census).accepted);
  EXPECT_EQ(Check(census).not_recounted, "it has no generator");

  census = World();
  census["generator"]["largest"] = 6;
  census["count"] = 28;
  census["classes"][2]["count"] = 23;
  EXPECT_TRUE(Check(census).accepted) << Check(census).why;
  EXPECT_EQ(Check(census).not_recounted, "its relations have more than 5 contacts");

  census = World();
  json& contacts = census["generator"]["contacts"];
  for (int x = 2; x < 1000; ++x) contacts.push_back(Contact(x, 1));
  census["count"] = 501501;  // binomial(1002, 2)
  census["classes"][2]["count"] = 501501 - 5;
  EXPECT_TRUE(Check(census).accepted) << Check(census).why;
  EXPECT_EQ(Check(census).not_recounted, "it has more than 500000 relations");

  census = World();
  census["generator"]["contacts"][1]["point"][0] = "123456789012345678901234567890";
  census["classes"][2]["relation"]["contacts"][1]["point"][0] = "123456789012345678901234567890";
  census["classes"][2]["relation"]["all"]["x"][1] = 1;
  census["classes"][2]["relation"]["all"]["x"][5] = 1;
  EXPECT_TRUE(Check(census).accepted) << Check(census).why;
  EXPECT_EQ(Check(census).not_recounted, "its numbers leave 64 bits");
}

TEST(Recount, OverflowOfAProductIsNoticed) {
  const auto contact = [](long x, long normal) {
    ContactNumbers c;
    c.planes = {{0, 0, normal}};
    c.rows = {{0, mpz_class(-x) * normal, 0, 0, 0, normal}};
    return c;
  };
  EXPECT_TRUE(Recount({contact(3000000, 1), contact(5000000, -1)}, 2).has_value());
  EXPECT_FALSE(Recount({contact(3000000000, 3), contact(5000000000, -5)}, 2).has_value());
}

TEST(MultisetCount, EqualsTheSumOverSizesOfTheStarsAndBars) {
  const auto count = [](std::size_t contacts, std::size_t largest) {
    return MultisetCount(contacts, largest).get_str();
  };
  EXPECT_EQ(count(0, 5), "1");
  EXPECT_EQ(count(7, 0), "1");
  EXPECT_EQ(count(3, 2), "10");  // 1 + 3 + 6
  EXPECT_EQ(count(54, 4), "424270");
}

}  // namespace
}  // namespace tact::check

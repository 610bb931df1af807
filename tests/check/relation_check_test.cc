#include <gtest/gtest.h>

#include "provers/check/check.h"
#include "tests/check/brute.h"

namespace tact::check {
namespace {

using brute::json;

std::string Why(const json& certificate) { return CheckCertificate(certificate.dump()).why; }

// A certificate changed at one place, by JSON pointer.
json With(const std::string& name, const std::string& pointer, const json& value) {
  json certificate = brute::Certificate(name);
  certificate[json::json_pointer(pointer)] = value;
  return certificate;
}

TEST(RelationCheck, ARefusalNamesThePlaceAndTheReason) {
  const std::string name = "edge_on_face";
  EXPECT_EQ(Why(With(name, "/relation/contacts/1/planes/0", {0, 0, 0})),
            "relation.contacts[1].planes[0]: zero normal");
  EXPECT_EQ(Why(With(name, "/relation/contacts/1/planes", json::array())),
            "relation.contacts[1].planes: no plane");
  EXPECT_EQ(Why(With(name, "/relation/contacts/0/point/3", 0)),
            "relation.contacts[0].point: W is not positive");
  EXPECT_EQ(Why(With(name, "/relation/all/x/5", 0)), "relation.all: row 0: neither B x nor y is positive");
  EXPECT_EQ(Why(With(name, "/relation/all/x/5", -1)), "relation.all: row 0: B x is negative");
  EXPECT_EQ(Why(With(name, "/relation/all/y/1", 1)), "relation.all: row 1: both B x and y are positive");
  EXPECT_EQ(Why(With(name, "/relation/all/y/1", -1)), "relation.all: row 1: y is negative");
  EXPECT_EQ(Why(With("opposed_points", "/relation/translation/y/1", 2)),
            "relation.translation: entry 2 of y^T B is not zero");
  EXPECT_EQ(Why(With(name, "/relation/dof/rotation/detaching", 2)),
            "relation.dof.rotation.detaching: the evidence shows 1");
  EXPECT_EQ(Why(With(name, "/relation/dof/singular", true)),
            "relation.dof.singular: no contact has several planes");
  EXPECT_EQ(Why(With(name, "/relation/contacts/0/point/0", 0.5)),
            "relation.contacts[0].point[0]: expected an integer (beyond 2^53: a string of digits), got the "
            "number 0.5");
  EXPECT_EQ(Why(With(name, "/asserts/1/is", "negative")), "asserts[1]: does not hold: the sum is \"3\"");
  EXPECT_EQ(Why(With(name, "/asserts/0/sum/rotation.kept", 1)),
            "asserts[0].sum.rotation.kept: no index is named \"rotation.kept\"");
}

TEST(RelationCheck, PointsAndEvidenceOfManyDigitsAreExact) {
  // The held edge a googol times as far out, and its stop's x scaled: the cones are the same.
  std::string googol(101, '0');
  googol[0] = '1';
  json certificate = brute::Certificate("held_edge");
  json& relation = certificate["relation"];
  for (int i : {2, 3}) relation["contacts"][i]["point"][0] = googol;
  relation["all"]["x"][3] = googol;
  EXPECT_EQ(Why(certificate), "");
  googol.back() = '1';
  relation["contacts"][3]["point"][0] = googol;
  EXPECT_EQ(Why(certificate), "relation.all: entry 1 of y^T B is not zero");
}

TEST(RelationCheck, ContactsMayHaveNamesThatAreStrings) {
  EXPECT_EQ(Why(With("held_edge", "/relation/contacts/4/name", "stop")), "");
  EXPECT_NE(Why(With("held_edge", "/relation/contacts/4/name", 4)), "");
}

TEST(RelationCheck, EachAssertWordMeansWhatItSays) {
  const std::vector<std::string> words = {"zero", "nonzero", "negative", "positive", "nonnegative"};
  const bool expected[3][5] = {
      {false, true, true, false, false}, {true, false, false, false, true}, {false, true, false, true, true}};
  for (int sign = -1; sign <= 1; ++sign) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      json certificate = brute::Certificate("edge_on_face");
      certificate["asserts"] = {
          {{"sum", {{"translation.maintaining", 1}, {"constant", sign - 2}}}, {"is", words[i]}}};
      EXPECT_EQ(Why(certificate).empty(), expected[sign + 1][i]) << words[i] << " of " << sign;
    }
  }
}

// Evidence with small entries for every relation of up to two contacts from a small world, found by trying.
json FindPair(const brute::Rows& rows, std::size_t width) {
  std::vector<int> implicit;
  for (const brute::Row& y : {brute::Row{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}}) {
    brute::Row x(width, -2);
    for (std::size_t place = 0; place < width;) {
      if (brute::PairIsRight(x, y, rows, implicit)) return {{"x", x}, {"y", y}};
      for (place = 0; place < width && ++x[place] > 2; ++place) x[place] = -2;
    }
  }
  return nullptr;
}

TEST(RelationCheck, EveryRelationOfTwoSmallContactsIsAcceptedWithItsBruteForceNumbersOnly) {
  std::vector<json> contacts;
  for (const json& point : {json{0, 0, 0, 1}, json{1, 0, 0, 1}, json{0, 2, 0, 2}}) {
    for (const json& plane : {json{1, 0, 0}, json{-1, 0, 0}, json{0, 0, 1}, json{0, 0, -1}}) {
      contacts.push_back({{"point", point}, {"planes", {plane}}});
    }
  }
  std::set<json> dofs;
  for (const json& first : contacts) {
    for (const json& second : contacts) {
      const brute::Rows rows = {brute::PlaneRow(first["point"], first["planes"][0]),
                                brute::PlaneRow(second["point"], second["planes"][0])};
      json certificate = brute::Certificate("free_object");
      json& relation = certificate["relation"];
      relation = {{"contacts", {first, second}},
                  {"all", FindPair(rows, 6)},
                  {"translation", FindPair(brute::RightHalf(rows), 3)}};
      ASSERT_FALSE(relation["all"].is_null() || relation["translation"].is_null()) << first << second;
      const json dof = brute::DofOf(relation["contacts"], relation["all"], relation["translation"]);
      relation["dof"] = dof;
      EXPECT_EQ(Why(certificate), "") << first << second;
      dofs.insert(dof);
      for (const auto& other : dofs) {
        relation["dof"] = other;
        EXPECT_EQ(Why(certificate).empty(), other == dof) << first << second;
      }
    }
  }
  EXPECT_GE(dofs.size(), 5u);
}

}  // namespace
}  // namespace tact::check

// Certificates about a rope's moves, right and changed. What must come out is known by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "provers/check/check.h"

namespace tact::check {
namespace {

using nlohmann::json;

std::string Why(const json& certificate) { return CheckCertificate(certificate.dump()).why; }

json Frame(const std::string& kind) {
  return {{"format", "tact-certificate"}, {"version", 1}, {"claim", "example"}, {"kind", kind}};
}

json Code(const std::vector<int>& sigma, const std::vector<int>& attr) {
  return {{"sigma", sigma}, {"attr", attr}};
}

// The rope folded back over itself.
json Fold() {
  json c = Frame("knot-move");
  c["before"] = Code({}, {});
  c["after"] = Code({3, 4, 1, 2}, {1, 3, 2, 4});
  c["move"] = {{"kind", "R2"},   {"direction", "add"},      {"segments", {1, 1}},
               {"end", nullptr}, {"selective_end", "same"}, {"attr", 1},
               {"order", "same"}};
  return c;
}

json MissedFold() {
  json c = Fold();
  c["kind"] = "knot-rule";
  c["misses"] = c["move"];
  c.erase("move");
  c["rule"] = {{"kind", "R2"}, {"same_height", true}, {"signs_differ", true}, {"whole_range", false}};
  return c;
}

// A triangle of the first reading of R_III: signs forgotten.
json WrongTriangle() {
  json c = Frame("knot-rule");
  c["before"] = Code({3, 6, 1, 5, 4, 2}, {1, 2, 2, 2, 1, 1});
  c["after"] = Code({5, 4, 6, 2, 1, 3}, {4, 3, 4, 4, 3, 3});
  c["rule"] = {{"kind", "R3"},
               {"named_at_both_times", true},
               {"faces", true},
               {"signs_kept", false},
               {"whole_range", true}};
  c["accepts"] = {6, 2, 4};
  return c;
}

json Shift() {
  json c = Frame("knot-move");
  c["before"] = Code({3, 6, 1, 5, 4, 2}, {1, 2, 2, 2, 1, 1});
  c["after"] = Code({5, 4, 6, 2, 1, 3}, {2, 1, 2, 2, 1, 1});
  c["move"] = {{"kind", "R3"},    {"direction", "shift"},    {"segments", {6, 2, 4}},
               {"end", nullptr},  {"selective_end", "same"}, {"attr", nullptr},
               {"order", nullptr}};
  return c;
}

TEST(KnotMoveCheck, RightCertificatesAreAccepted) {
  for (const json& c : {Fold(), MissedFold(), WrongTriangle(), Shift()}) EXPECT_EQ(Why(c), "") << c.dump(1);
}

TEST(KnotMoveCheck, AMoveIsUndoneByItsRemoval) {
  json c = Fold();
  std::swap(c["before"], c["after"]);
  EXPECT_EQ(Why(c), "move: no lens is there");
  c["move"]["direction"] = "remove";
  EXPECT_EQ(Why(c), "");
}

TEST(KnotMoveCheck, OneChangedNumberOrWordIsRefused) {
  for (const json& original : {Fold(), MissedFold(), WrongTriangle(), Shift()}) {
    const json flat = original.flatten();
    for (const auto& [path, value] : flat.items()) {
      const json::json_pointer at(path);
      if (value.is_number()) {
        for (const int change : {-1, 1, 2, 7, 1000000}) {
          json c = original;
          c.at(at) = value.get<int>() + change;
          EXPECT_NE(Why(c), "") << path << " + " << change;
        }
      } else if (value.is_string() && path != "/claim") {
        json c = original;
        c.at(at) = value.get<std::string>() + "s";
        EXPECT_NE(Why(c), "") << path;
      }
    }
  }
}

TEST(KnotMoveCheck, AMissingOrUnknownKeyIsRefused) {
  for (const json& original : {Fold(), MissedFold(), WrongTriangle(), Shift()}) {
    for (const auto& [key, value] : original.items()) {
      json c = original;
      c.erase(key);
      EXPECT_NE(Why(c), "") << key;
      if (!value.is_object()) continue;
      for (const auto& [inner, unused] : value.items()) {
        c = original;
        c[key].erase(inner);
        EXPECT_NE(Why(c), "") << key << "/" << inner;
      }
      c = original;
      c[key]["more"] = 1;
      EXPECT_NE(Why(c), "") << key;
    }
    json c = original;
    c["more"] = 1;
    EXPECT_NE(Why(c), "");
  }
}

TEST(KnotMoveCheck, ACorrectedRuleHasNoSuchPair) {
  json missed = MissedFold();
  missed["rule"]["whole_range"] = true;
  EXPECT_EQ(Why(missed), "misses: the rule does find it");
  json wrong = WrongTriangle();
  wrong["rule"]["signs_kept"] = true;
  EXPECT_EQ(Why(wrong), "accepts: the rule does not accept them");
  wrong = WrongTriangle();
  wrong["after"] = Shift()["after"];
  EXPECT_EQ(Why(wrong), "accepts: such a move does lead there");
  json shift = Shift();
  shift["move"]["segments"] = {2, 6, 4};
  EXPECT_EQ(Why(shift), "move: not over both, between and under both in this order");
}

TEST(KnotMoveCheck, ADiagramOfNoSphereIsRefused) {
  json c = Fold();
  c["after"] = Code({3, 4, 1, 2}, {1, 1, 2, 2});
  EXPECT_EQ(Why(c), "after: no sphere holds this diagram");
}

}  // namespace
}  // namespace tact::check

// Drawings as certificates, right and changed. What must come out is known by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "provers/check/check.h"

namespace tact::check {
namespace {

using nlohmann::json;

std::string Why(const json& certificate) { return CheckCertificate(certificate.dump()).why; }

json Drawing(const std::vector<std::vector<long>>& points, const std::vector<int>& sigma,
             const std::vector<int>& attr) {
  return {{"format", "tact-certificate"}, {"version", 1},     {"claim", "example"},
          {"kind", "knot-drawing"},       {"points", points}, {"p_data", {{"sigma", sigma}, {"attr", attr}}}};
}

// Right along the x axis, up, back to the left, and down through the first edge, below it: the first strand is over, and is met from
// left to right; +.
json Loop() {
  return Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, -2, 0, 1}}, {2, 1}, {1, 2});
}

TEST(KnotDrawingCheck, AcceptsALoop) { EXPECT_EQ(Why(Loop()), ""); }

TEST(KnotDrawingCheck, AcceptsTheStraightRopeAndDenominators) {
  EXPECT_EQ(Why(Drawing({{0, 0, 0, 1}, {1, 5, 2, 1}}, {}, {})), "");
  json scaled = Loop();
  for (json& point : scaled["points"]) {
    for (json& entry : point) entry = entry.get<long>() * 3;
  }
  scaled["points"][2] = {28, 28, 5, 7};
  EXPECT_EQ(Why(scaled), "");
}

TEST(KnotDrawingCheck, SaysWhatIsWrong) {
  const std::vector<std::pair<json, std::string>> refused = {
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, -2, 0, 1}}, {2, 1}, {3, 4}),
       "of other P-data"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, -2, 0, 1}}, {2, 1}, {2, 1}),
       "of other P-data"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, -2, 0, 1}}, {}, {}),
       "has 1 intersections"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, 1, 0, 1}}, {2, 1}, {1, 2}),
       "has 0 intersections"},
      {Drawing({{0, 0, 0, 1}, {4, 0, 0, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, -2, 0, 1}}, {2, 1}, {1, 2}),
       "meets itself"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, 0, 0, 1}}, {2, 1}, {1, 2}),
       "seen on an edge"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {4, 0, 0, 1}}, {}, {}),
       "seen on an edge"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {4, 4, 0, 1}, {0, 4, 0, 1}, {0, 0, 0, 1}}, {}, {}),
       "seen on an edge"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {2, 0, 0, 1}}, {}, {}), "turn back"},
      {Drawing({{0, 0, 1, 1}, {4, 0, 1, 1}, {5, 1, 0, 1}, {6, 0, 0, 1}, {3, 0, 0, 1}}, {}, {}), "seen on"},
      {Drawing({{0, 0, 1, 1}, {0, 0, 0, 1}}, {}, {}), "seen where the point before it is"},
      {Drawing({{0, 0, 1, 1}, {1, 0, 1, 0}}, {}, {}), "positive denominator"},
      {Drawing({{0, 0, 1, 1}, {1, 0, 1, -1}}, {}, {}), "positive denominator"},
      {Drawing({{0, 0, 1, 1}}, {}, {}), "at least two points"},
      // Three edges through (2, 0).
      {Drawing({{0, 0, 2, 1}, {4, 0, 2, 1}, {4, 4, 1, 1}, {0, -4, 1, 1}, {2, -4, 0, 1}, {2, 4, 0, 1}},
               {3, 5, 1, 6, 2, 4}, {1, 1, 2, 1, 2, 2}),
       "three edges"},
  };
  for (const auto& [certificate, why] : refused) {
    EXPECT_NE(Why(certificate).find(why), std::string::npos) << certificate.dump() << "\n"
                                                             << Why(certificate);
  }
  json strange = Loop();
  strange["outer"] = 0;
  EXPECT_NE(Why(strange), "");
}

// Rising edges: the heights that count are those where the strands cross.
TEST(KnotDrawingCheck, ComparesHeightsWhereStrandsCross) {
  const std::vector<int> sigma = {2, 1};
  json steep =
      Drawing({{0, 0, 0, 1}, {4, 0, 4, 1}, {4, 4, 0, 1}, {2, 4, 0, 1}, {2, -2, 3, 1}}, sigma, {2, 1});
  // At (2, 0) the first edge is at height 2, the last at 4 * 3 / 6 = 2: they meet.
  EXPECT_NE(Why(steep).find("meets itself"), std::string::npos);
  steep["points"][4][2] = 4;
  steep["p_data"]["attr"] = {4, 3};
  EXPECT_EQ(Why(steep), "");
}

}  // namespace
}  // namespace tact::check

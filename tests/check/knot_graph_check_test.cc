// Certificates about knot graphs, their faces and the parts of P-data, right and changed. What must come out is known
// by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "provers/check/check.h"

namespace tact::check {
namespace {

using nlohmann::json;

std::string Why(const json& certificate) { return CheckCertificate(certificate.dump()).why; }

json Frame(const std::string& kind, const std::vector<int>& sigma, const std::vector<int>& attr) {
  return {{"format", "tact-certificate"},
          {"version", 1},
          {"claim", "example"},
          {"kind", kind},
          {"p_data", {{"sigma", sigma}, {"attr", attr}}}};
}

// The overhand knot's graph with its parallel edges e1 and e4 exchanged; its own drawing is [1,-3,4], [2,5,-1,-4],
// [3,-5,-2].
json Exchanged() {
  json c = Frame("knot-embedding", {4, 5, 6, 1, 2, 3}, {1, 2, 1, 2, 1, 2});
  c["rotation"] = {{4, -3, 1}, {2, 5, -4, -1}, {3, -5, -2}};
  c["nameless"] = false;
  return c;
}

// Without the caution {e1, e2, e3} may be taken for a face [thesis, 5.4.1].
json WrongLoop() {
  json c = Frame("knot-face-search", {4, 5, 6, 1, 2, 3}, {1, 2, 1, 2, 1, 2});
  c["rule"] = {{"caution", "none"}, {"order", "shortest-first"}};
  c["chooses"] = {1, 2, 3};
  c["always"] = false;
  return c;
}

// A rope of two intersections that leads from one side of itself to the other, put into a loop.
json Torus() {
  json c = Frame("knot-parts", {6, 4, 5, 2, 3, 1}, {1, 1, 2, 2, 1, 2});
  c["parts"] = {{1, 6}, {2, 3, 4, 5}};
  return c;
}

// A loop, halved, and the face in it: a triangle with a doubled side.
json Triangle() {
  json c = Frame("knot-subdivision", {2, 1}, {1, 2});
  c["faces"] = {{1}, {1}};
  c["without"] = json::array();
  return c;
}

// Two kinks, the face outside left out: nothing but the edge between them joins their insides. 0 and 1 are the
// intersections.
json TwoKinks() {
  json c = Frame("knot-subdivision", {2, 1, 4, 3}, {1, 2, 1, 2});
  c["faces"] = {{1, 2, 2, 3}, {1}, {3}};
  c["without"] = {0, 1};
  return c;
}

TEST(KnotGraphCheck, RightCertificatesAreAccepted) {
  for (const json& c : {Exchanged(), WrongLoop(), Torus(), Triangle(), TwoKinks()})
    EXPECT_EQ(Why(c), "") << c.dump(1);
}

TEST(KnotGraphCheck, AKeyLessOrMoreIsRefused) {
  for (const json& original : {Exchanged(), WrongLoop(), Torus(), Triangle()}) {
    for (const auto& [key, value] : original.items()) {
      json c = original;
      c.erase(key);
      EXPECT_NE(Why(c), "") << key;
    }
    json c = original;
    c["more"] = 1;
    EXPECT_EQ(Why(c), "unknown key \"more\"");
  }
}

TEST(KnotGraphCheck, TheOwnDrawingAndItsMirrorImageAreNoSecondOne) {
  json c = Exchanged();
  c["rotation"] = {{4, 1, -3}, {-1, -4, 2, 5}, {3, -5, -2}};
  EXPECT_EQ(Why(c), "rotation: this is the drawing that the P-data has");
  c["rotation"] = {{-3, 1, 4}, {5, 2, -4, -1}, {-2, -5, 3}};
  EXPECT_EQ(Why(c), "rotation: this is the mirror image of the drawing that the P-data has");
}

TEST(KnotGraphCheck, DrawingsThatAreNoneOnASphereAreRefused) {
  json c = Exchanged();
  c["rotation"][0] = {1, -3, 4};  // exchanged at one end only
  EXPECT_EQ(Why(c), "rotation: the faces do not add up to a sphere");
  c["rotation"][0] = {1, -3, 3};
  EXPECT_EQ(Why(c), "rotation[0]: other edges leave this intersection");
  c["rotation"].erase(0);
  EXPECT_EQ(Why(c), "rotation: expected an order for each intersection");
}

TEST(KnotGraphCheck, DrawingsThatDifferInNamesOnlyAreNoNamelessOnes) {
  json c = Exchanged();
  c["nameless"] = true;
  EXPECT_EQ(Why(c), "nameless: without names the two drawings are alike");
}

TEST(KnotGraphCheck, ReducibleOrTooSmallPDataAreNoneOfTheStatements) {
  json c = Exchanged();
  c["p_data"] = TwoKinks()["p_data"];
  EXPECT_EQ(Why(c), "p_data: some columns hold their own mates: reducible");
  c["p_data"] = Triangle()["p_data"];
  EXPECT_NE(Why(c).find("fewer intersections"), std::string::npos);
  c["p_data"] = Torus()["p_data"];
  EXPECT_EQ(Why(c), "p_data: no sphere holds this diagram");
}

TEST(KnotGraphCheck, ASearchThatGoesRightIsNotSaidToGoWrong) {
  json c = WrongLoop();
  c["chooses"] = {1, 4};  // a face
  EXPECT_EQ(Why(c), "chooses: the rule never chooses this after faces only, or it is a face");
  c["chooses"] = {3, 2, 1};
  EXPECT_EQ(Why(c), "chooses[1]: edges count from 1 and ascend");
  c = WrongLoop();
  c["rule"]["caution"] = "edges";
  EXPECT_NE(Why(c), "");
  c = WrongLoop();
  c["always"] = true;
  EXPECT_EQ(Why(c), "always: whether some choices give all faces is not as said");
  c["rule"]["caution"] = "some";
  EXPECT_EQ(Why(c), "rule.caution: no reading has this name");
}

// Counted as in Definition 2 the caution forbids {e2, e3, e4}, a face [thesis, 5.4.1].
TEST(KnotGraphCheck, TheCautionCountedFromTheSelectiveEndNeverFindsAllFaces) {
  json c = WrongLoop();
  c["rule"] = {{"caution", "segments"}, {"order", "shortest-first"}};
  c["always"] = true;
  EXPECT_EQ(Why(c), "");
}

TEST(KnotGraphCheck, PartsAreAllColumnsIrreducibleAndOfASphere) {
  json c = Torus();
  c["parts"] = {{1, 6}};
  EXPECT_EQ(Why(c), "parts: a column is in no part");
  c["parts"] = {{1, 6}, {2, 3, 4, 5, 6}};
  EXPECT_EQ(Why(c), "parts[1][4]: columns count from 1, ascend in a part and are in one part each");
  c["parts"] = {{1, 6}, {2, 4}, {3, 5}};
  EXPECT_EQ(Why(c), "parts: columns 2 and 3 alternate with their mates and are in different parts");
  c["parts"] = {{1, 2}, {3, 4, 5, 6}};
  EXPECT_EQ(Why(c), "parts[0]: a column's mate is missing");
  c["parts"] = {{1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(Why(c), "parts[0]: this part is empty or reducible");
  c["p_data"] = TwoKinks()["p_data"];
  EXPECT_EQ(Why(c), "p_data: a sphere holds this diagram");
}

TEST(KnotGraphCheck, ASubdivisionThatHangsTogetherIsRefused) {
  json c = TwoKinks();
  c["without"] = {2, 4};  // the middles of both loops
  EXPECT_EQ(Why(c), "without: there are more than three vertices, and the rest hangs together");
  c["without"] = {0, 1, 2};
  EXPECT_EQ(Why(c), "without: three-connected is about two vertices taken away");
  c = TwoKinks();
  c["faces"] = {{1, 2, 3}, {1}, {3}};
  EXPECT_EQ(Why(c), "faces: these are not the faces");
}

}  // namespace
}  // namespace tact::check

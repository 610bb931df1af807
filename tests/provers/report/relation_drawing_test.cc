#include "provers/report/relation_drawing.h"

#include <gtest/gtest.h>

#include "tests/provers/report/svg_numbers.h"
#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::RealizeRelation;

const ContactRelation kCorner = {{{{0, 0, 0}, {{0, 0, 1}}, "floor"},
                                  {{1, 0, 0}, {{0, 0, 1}}, "floor, too"},
                                  {{0, 1, 1}, {{1, 0, 0}}, "wall"},
                                  {{1, 0, 1}, {{0, 1, 1}}, "slope"}}};

const std::string kWall = "stroke=\"#4b6f93\"", kOutline = "stroke-dasharray=\"0.1 3.2\"",
                  kConcave = "stroke=\"#7b2fa8\"";

TEST(RelationDrawing, IsOneWellFormedSvgThatSaysWhatItShows) {
  for (const View& view : {View(), AlongAxis('x'), AlongAxis('y'), AlongAxis('z')}) {
    const XmlContents contents = ReadXml(DrawRelationSolids(RealizeRelation(kCorner), view));
    EXPECT_EQ(contents.error, "");
    EXPECT_EQ(contents.elements.at("svg"), 1);
    EXPECT_TRUE(contents.ids.empty());
    EXPECT_NE(contents.text.find("2 solids, 4 contacts, 0 of them singular"), std::string::npos);
  }
}

TEST(RelationDrawing, ContactWallsAreWallsAndTheRestOfTheCavityIsOutlines) {
  const std::string hovering = DrawRelationSolids(RealizeRelation({})),
                    corner = DrawRelationSolids(RealizeRelation(kCorner));
  EXPECT_EQ(Count(hovering, kWall), 0);
  EXPECT_EQ(Count(hovering, kOutline), 6);  // the box around the block, and not the one around that
  EXPECT_EQ(Count(corner, kWall), 3);
  EXPECT_EQ(Count(corner, kOutline), 4);  // the slope cuts the box's front away, the floor and the wall
  EXPECT_EQ(Count(corner, kConcave), 0);
}

TEST(RelationDrawing, EveryContactHasAnArrow) {
  EXPECT_EQ(Count(DrawRelationSolids(RealizeRelation(kCorner)), "stroke=\"#0a4fa8\" stroke-width=\"2.6\""),
            4);
}

}  // namespace
}  // namespace tact::provers

#include "provers/report/solid_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "provers/report/paint_order.h"
#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::PolygonSoup;
using algebra::Polyhedron;
using algebra::Rational;
using Outline = std::vector<std::pair<Rational, Rational>>;

// The solid between y = low and y = high over an outline in x and z, counter-clockwise seen from -y.
Polyhedron Prism(const Outline& outline, int low, int high) {
  PolygonSoup soup;
  const size_t n = outline.size();
  std::vector<size_t> front, back;
  for (const int y : {low, high}) {
    for (const auto& [x, z] : outline) soup.points.push_back({x, y, z});
  }
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    front.push_back(i);
    back.push_back(2 * n - 1 - i);
    soup.polygons.push_back({j, i, i + n, j + n});
  }
  soup.polygons.push_back(front);
  soup.polygons.push_back(back);
  return BuildPolyhedron(soup);
}

const Outline kSlot = {{0, 0}, {10, 0}, {10, 6}, {7, 6}, {7, 2}, {3, 2}, {3, 6}, {0, 6}};
const Outline kPeg = {{3, 2}, {6, 2}, {6, 9}, {3, 9}};

std::vector<DrawnSolid> PegInSlot() {
  return {{Prism(kSlot, 0, 8), Part::kFixed}, {Prism(kPeg, 1, 7), Part::kMoving}};
}

ContactRelation Corner() {
  return {{{{3, 1, 2}, {{1, 0, 0}, {0, 0, 1}}, "corner"}, {{6, 1, 2}, {{0, 0, 1}}, "foot"}}};
}

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(SolidDrawing, IsOneWellFormedSvgThatSaysWhatItShows) {
  for (const View& view : {View(), AlongAxis('x'), AlongAxis('y'), AlongAxis('z')}) {
    const std::string svg = DrawContactRelation(PegInSlot(), Corner(), view);
    EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_TRUE(svg.ends_with("</svg>"));
    const XmlContents contents = ReadXml(svg);
    EXPECT_EQ(contents.error, "");
    EXPECT_EQ(contents.elements.at("svg"), 1);
    EXPECT_TRUE(contents.ids.empty());
    EXPECT_NE(contents.text.find("2 solids, 2 contacts, 1 of them singular"), std::string::npos);
    EXPECT_EQ(Count(svg, "nan"), 0);
    EXPECT_EQ(Count(svg, "inf"), 0);
  }
}

TEST(SolidDrawing, AnArrowForEachPlaneInTheColourOfItsContact) {
  const std::string svg = DrawContactRelation(PegInSlot(), Corner());
  EXPECT_EQ(Count(svg, "stroke=\"#b5127a\" stroke-width=\"2.6\""), 2);  // the singular contact has two planes
  EXPECT_EQ(Count(svg, "stroke=\"#0a4fa8\" stroke-width=\"2.6\""), 1);
}

TEST(SolidDrawing, ANormalAlongTheLineOfSightIsARing) {
  const std::string above = DrawContactRelation(PegInSlot(), Corner(), AlongAxis('z'));
  EXPECT_EQ(Count(above, "r=\"9.5\""), 2);
  EXPECT_EQ(Count(above, "stroke=\"#b5127a\" stroke-width=\"2.6\""), 1);
}

TEST(SolidDrawing, ContactsBehindTheMovingSolidAreHollow) {
  const std::string hollow = "fill=\"#ffffff\" fill-opacity=\"0.7\"";
  const ContactRelation behind = {{{{4, 7, 4}, {{0, -1, 0}}, ""}}}, before = {{{{4, 1, 4}, {{0, 1, 0}}, ""}}};
  EXPECT_EQ(Count(DrawContactRelation(PegInSlot(), behind, AlongAxis('y')), hollow), 1);
  EXPECT_EQ(Count(DrawContactRelation(PegInSlot(), before, AlongAxis('y')), hollow), 0);
}

TEST(SolidDrawing, ConcaveEdgesAreDrawnAsSuch) {
  const std::string concave = "stroke=\"#7b2fa8\"";
  EXPECT_GT(Count(DrawContactRelation({{Prism(kSlot, 0, 8), Part::kFixed}}, {}), concave), 0);
  EXPECT_EQ(Count(DrawContactRelation({{Prism(kPeg, 0, 8), Part::kFixed}}, {}), concave), 0);
}

TEST(SolidDrawing, TheFlatViewShowsTheFacesTurnedToIt) {
  // Of a fixed box its near and its far face, of a moving one the near face alone.
  const std::string fill = "fill-rule=\"evenodd\"";
  EXPECT_EQ(Count(DrawContactRelation({{Prism(kPeg, 0, 8), Part::kFixed}}, {}, AlongAxis('y')), fill), 2);
  EXPECT_EQ(Count(DrawContactRelation({{Prism(kPeg, 0, 8), Part::kMoving}}, {}, AlongAxis('y')), fill), 1);
  EXPECT_EQ(Count(DrawContactRelation({{Prism(kPeg, 0, 8), Part::kMoving}}, {}), fill), 3);
}

TEST(SolidDrawing, RelationsWithoutSolidsOrWithHugeNumbersAreDrawnToo) {
  EXPECT_EQ(ReadXml(DrawContactRelation({}, Corner())).error, "");
  EXPECT_EQ(ReadXml(DrawContactRelation({}, {})).error, "");
  const Rational huge = *Rational::Parse("1e300");
  const std::string svg = DrawContactRelation({}, {{{{0, 0, 0}, {{huge, huge, 0}}, ""}}});
  EXPECT_EQ(Count(svg, "nan"), 0);
  EXPECT_EQ(Count(svg, "stroke-width=\"2.6\""), 1);
}

TEST(SolidDrawing, UselessViewsAndZeroNormalsAreRefused) {
  View along_up;
  along_up.toward_viewer = {0, 0, 2};
  EXPECT_THROW(DrawContactRelation({}, {}, along_up), PreconditionError);
  EXPECT_THROW(AlongAxis('w'), PreconditionError);
  EXPECT_THROW(DrawContactRelation({}, {{{{0, 0, 0}, {{0, 0, 0}}, ""}}}), PreconditionError);
}

TEST(Projection, FlatViewsShowTheAxesTheyName) {
  const auto expect = [](char axis, const algebra::Vector3& right, const algebra::Vector3& up) {
    const Projection project(AlongAxis(axis));
    EXPECT_NEAR(project(right).x, 1, 1e-12) << axis;
    EXPECT_NEAR(project(up).y, 1, 1e-12) << axis;
  };
  expect('x', {0, 1, 0}, {0, 0, 1});
  expect('y', {1, 0, 0}, {0, 0, 1});
  expect('z', {1, 0, 0}, {0, 1, 0});
}

// A square of side 2 about (x, y) at a depth, perhaps facing away.
FlatFace Square(double x, double y, double z, double facing = 1) {
  return {{{{x - 1, y - 1, z}, {x + 1, y - 1, z}, {x + 1, y + 1, z}, {x - 1, y + 1, z}}}, {0, 0, facing}};
}

TEST(PaintOrder, NearerFacesComeLater) {
  EXPECT_EQ(PaintOrder({Square(0, 0, 3), Square(0.5, 0, 1), Square(0, 0, 2)}, 1e-9),
            (std::vector<size_t>{1, 2, 0}));
  EXPECT_EQ(PaintOrder({Square(0, 0, 1), Square(0, 0, 1, -1)}, 1e-9), (std::vector<size_t>{1, 0}));
  EXPECT_TRUE(PaintOrder({}, 1e-9).empty());
}

TEST(PaintOrder, ALongSlantedFaceIsOrderedWhereItOverlapsNotByItsMiddle) {
  // It runs from depth 0 at x = 0 to depth 100 at x = 10; the square lies before its depth of at most 20 there.
  const double length = std::hypot(10, 100);
  const FlatFace slanted{{{{0, -1, 0}, {10, -1, 100}, {10, 1, 100}, {0, 1, 0}}},
                         {-100 / length, 0, 10 / length}};
  EXPECT_EQ(PaintOrder({Square(1, 0, 20.5), slanted}, 1e-9), (std::vector<size_t>{1, 0}));
}

TEST(PaintOrder, ACycleIsCutAndEveryFacePaintedOnce) {
  // Three bars, each over the next where they cross.
  const auto bar = [](double angle) {
    const double c = std::cos(angle), s = std::sin(angle), tilt = 0.5, length = std::hypot(1, tilt);
    FlatFace face{{{}}, {-tilt * c / length, -tilt * s / length, 1 / length}};
    for (const auto& [along, across] : {std::pair{-4.0, 1.0}, {4.0, 1.0}, {4.0, 1.5}, {-4.0, 1.5}}) {
      face.loops[0].push_back({along * c - across * s, along * s + across * c, tilt * along});
    }
    return face;
  };
  std::vector<size_t> order = PaintOrder({bar(0), bar(2.0944), bar(4.1888)}, 1e-9);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (std::vector<size_t>{0, 1, 2}));
}

TEST(PaintOrder, CoversKnowsHoles) {
  FlatFace framed = Square(0, 0, 0);
  framed.loops.push_back({{-0.5, -0.5, 0}, {-0.5, 0.5, 0}, {0.5, 0.5, 0}, {0.5, -0.5, 0}});
  EXPECT_FALSE(Covers(framed, 0, 0, 0));
  EXPECT_TRUE(Covers(framed, 0.75, 0, 0));
  EXPECT_FALSE(Covers(framed, 1.5, 0, 0));
  EXPECT_TRUE(Covers(framed, 1.0, 0.3, 1e-9));
}

}  // namespace
}  // namespace tact::provers

#include "provers/report/sphere_drawing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "tests/algebra/uniform.h"
#include "tests/provers/report/svg_numbers.h"
#include "tests/provers/report/ten_regions.h"
#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::Rational;
using algebra::Vector3;

const std::string kLegalFront = "fill=\"#1f8a70\" fill-opacity=\"0.55\"";
const std::string kLegalBack = "fill=\"#1f8a70\" fill-opacity=\"0.3\"";
const std::string kMaintainingFront = "fill=\"#c8402f\" fill-opacity=\"0.55\"";
const std::string kLegalLine = "stroke=\"#1f8a70\"", kMaintainingLine = "stroke=\"#c8402f\"";
const std::string kLegalPoint = "fill=\"#1f8a70\" stroke=\"#ffffff\"";
const std::string kMaintainingPoint = "fill=\"#c8402f\" stroke=\"#ffffff\"";
const std::string kDisc = "fill=\"#eef1f4\"", kDashed = "stroke-dasharray", kHollow = "fill-opacity=\"0.7\"";

View From(double x, double y, double z) {
  View view = kSphereView;
  view.toward_viewer = {x, y, z};
  if (x == 0 && y == 0) view.up = {0, 1, 0};
  return view;
}

// Of the disc, the share that the near or the far legal directions cover.
double Share(const std::string& svg, const std::string& style) {
  const double radius = std::stod(svg.substr(svg.rfind("r=\"", svg.find(kDisc)) + 3));
  return AreaOfPath(svg, style) / (std::numbers::pi * radius * radius);
}

TEST(SphereDrawing, IsOneWellFormedSvgThatNamesTheRegionAndTheAxes) {
  for (const RegionExample& example : TenRegions()) {
    for (const View& view : {kSphereView, AlongAxis('x'), AlongAxis('y'), AlongAxis('z'), From(1, 1, -1)}) {
      const std::string svg = DrawLegalDirections(Normals(example.normals), view);
      const XmlContents contents = ReadXml(svg);
      EXPECT_EQ(contents.error, "");
      EXPECT_EQ(contents.elements.at("svg"), 1);
      EXPECT_EQ(contents.elements.at("text"), 3);
      EXPECT_TRUE(contents.ids.empty());
      EXPECT_NE(contents.text.find(std::string("legal translations: ") + example.name), std::string::npos);
      EXPECT_EQ(Count(svg, "nan"), 0);
      EXPECT_EQ(Count(svg, "inf"), 0);
    }
  }
}

TEST(SphereDrawing, AreasAreThoseOfTheProjectedRegions) {
  constexpr double kClose = 2e-3;  // of the disc: arcs are drawn in steps of three degrees
  // Seen along its axis a hemisphere is the disc; from the side, half of it on either side of the sphere.
  const ContactRelation up = Normals({{0, 0, 1}});
  EXPECT_NEAR(Share(DrawLegalDirections(up, From(0, 0, 1)), kLegalFront), 1, kClose);
  EXPECT_EQ(Share(DrawLegalDirections(up, From(0, 0, 1)), kLegalBack), 0);
  EXPECT_NEAR(Share(DrawLegalDirections(up, From(0, 0, -1)), kLegalBack), 1, kClose);
  EXPECT_EQ(Share(DrawLegalDirections(up, From(0, 0, -1)), kLegalFront), 0);
  EXPECT_NEAR(Share(DrawLegalDirections(up, From(1, 0, 0)), kLegalFront), 0.5, kClose);
  EXPECT_NEAR(Share(DrawLegalDirections(up, From(1, 0, 0)), kLegalBack), 0.5, kClose);
  // An octant's vector area is (pi / 4) (1, 1, 1), of which the view along (1, 1, 1) shows the length.
  const ContactRelation octant = Normals({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_NEAR(Share(DrawLegalDirections(octant, From(1, 1, 1)), kLegalFront), std::sqrt(3.0) / 4, kClose);
  EXPECT_NEAR(Share(DrawLegalDirections(octant, From(-1, -1, -1)), kLegalBack), std::sqrt(3.0) / 4, kClose);
  // Where nothing constrains, everything maintains.
  EXPECT_NEAR(Share(DrawLegalDirections(Normals({})), kMaintainingFront), 1, kClose);
}

TEST(SphereDrawing, MaintainingDirectionsHaveTheirColour) {
  for (const RegionExample& example : TenRegions()) {
    const std::string svg = DrawLegalDirections(Normals(example.normals), From(3, -2, 1));
    const algebra::TranslationDof dof = ComputeMotionDof(Normals(example.normals)).translation;
    EXPECT_EQ(Count(svg, "#c8402f") > 0, dof.maintaining > 0) << example.name;
    EXPECT_EQ(Count(svg, "#1f8a70") > 0, dof.detaching > 0) << example.name;
  }
}

TEST(SphereDrawing, TheFarSideIsDashedAndHollow) {
  const std::vector<Vector3> along_x = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}};
  const std::string near = DrawLegalDirections(Normals(along_x), From(2, 1, 1)),
                    far = DrawLegalDirections(Normals(along_x), From(-2, 1, 1));
  EXPECT_EQ(Count(near, kLegalPoint), 1);
  EXPECT_EQ(Count(near, kHollow), 0);
  EXPECT_EQ(Count(far, kLegalPoint), 0);
  EXPECT_EQ(Count(far, kHollow), 1);
  const std::vector<Vector3> both = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, -1, 0}};
  const std::string opposite = DrawLegalDirections(Normals(both), From(2, 1, 1));
  EXPECT_EQ(Count(opposite, kMaintainingPoint), 1);
  EXPECT_EQ(Count(opposite, kHollow), 1);
  // A great circle is half near, half far; one that is the outline is near.
  const std::vector<Vector3> level = {{0, 0, 1}, {0, 0, -1}};
  EXPECT_EQ(Count(DrawLegalDirections(Normals(level), From(1, 0, 1)), kDashed), 1);
  EXPECT_EQ(Count(DrawLegalDirections(Normals(level), From(1, 0, 1)), kMaintainingLine), 2);
  EXPECT_EQ(Count(DrawLegalDirections(Normals(level), From(0, 0, 1)), kDashed), 0);
  EXPECT_EQ(Count(DrawLegalDirections(Normals(level), From(0, 0, 1)), kMaintainingLine), 1);
}

TEST(SphereDrawing, TheBorderOfAnAreaIsDrawnAndTheOctantsOfTheViewAreNot) {
  EXPECT_EQ(Count(DrawLegalDirections(Normals({{0, 0, 1}}), From(0, 0, 1)), kLegalLine), 1);
  EXPECT_EQ(Count(DrawLegalDirections(Normals({}), From(0, 0, 1)), kMaintainingLine), 0);
}

TEST(SphereDrawing, HugeNumbersAreDrawnAndWhatIsNoNonSingularRelationIsRefused) {
  const Rational huge = *Rational::Parse("1e300");
  const std::string svg = DrawLegalDirections(Normals({{huge, huge, 0}, {-huge, 1, 1}}));
  EXPECT_EQ(ReadXml(svg).error, "");
  EXPECT_EQ(Count(svg, "nan"), 0);
  EXPECT_THROW(DrawLegalDirections(Normals({{0, 0, 0}})), PreconditionError);
  EXPECT_THROW(DrawLegalDirections({{{{0, 0, 0}, {}, ""}}}), PreconditionError);
  EXPECT_THROW(DrawLegalDirections({{{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}}, ""}}}), PreconditionError);
  View along_up = kSphereView;
  along_up.toward_viewer = {0, 0, 2};
  EXPECT_THROW(DrawLegalDirections({}, along_up), PreconditionError);
}

// The near and the far share of the disc against a count of directions, from any side.
RC_GTEST_PROP(SphereDrawing, AreasAreWhatCountingDirectionsGives, ()) {
  const auto vector = [] { return Vector3{Uniform(-2, 3), Uniform(-2, 3), Uniform(-2, 3)}; };
  std::vector<Vector3> normals(static_cast<size_t>(Uniform(1, 4)));
  for (Vector3& n : normals) n = vector();
  RC_PRE(std::none_of(normals.begin(), normals.end(), [](const Vector3& n) { return n.IsZero(); }));
  const std::array<double, 3> t = ToDouble(vector());
  RC_PRE(t[0] != 0 || t[1] != 0);
  const View view = From(t[0], t[1], t[2]);
  const std::string svg = DrawLegalDirections(Normals(normals), view);

  const Projection project(view);
  std::vector<ViewPoint> seen;
  for (const Vector3& n : normals) seen.push_back(project.Direction(n));
  constexpr int kGrid = 120;
  int disc = 0, front = 0, back = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const double x = (2 * i + 1.0) / kGrid - 1, y = (2 * j + 1.0) / kGrid - 1, square = 1 - x * x - y * y;
      if (square < 0) continue;
      const auto legal = [&](double z) {
        return std::all_of(seen.begin(), seen.end(),
                           [&](const ViewPoint& n) { return n.x * x + n.y * y + n.z * z >= 0; });
      };
      ++disc;
      front += legal(std::sqrt(square));
      back += legal(-std::sqrt(square));
    }
  }
  RC_ASSERT(std::abs(Share(svg, kLegalFront) - static_cast<double>(front) / disc) < 0.02);
  RC_ASSERT(std::abs(Share(svg, kLegalBack) - static_cast<double>(back) / disc) < 0.02);
}

}  // namespace
}  // namespace tact::provers

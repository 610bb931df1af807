#include "provers/report/knot_drawing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>
#include <sstream>

#include "algebra/error.h"
#include "algebra/knot/curve_views.h"
#include "tests/algebra/knot/p_data_world.h"
#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

using knot::PData;

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

KnotDrawingOptions Outside(int face) {
  KnotDrawingOptions options;
  options.outer = face;
  return options;
}

struct Point {
  double x, y;
};
using Stroke = std::array<Point, 4>;

std::vector<Stroke> StrokesOf(const std::string& svg) {
  static const std::regex kPath("<path d=\"M([^\"C]*)C([^\"]*)\"");
  std::vector<Stroke> strokes;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), kPath); it != std::sregex_iterator(); ++it) {
    std::istringstream numbers((*it)[1].str() + " " + (*it)[2].str());
    Stroke stroke;
    for (Point& point : stroke) numbers >> point.x >> point.y;
    EXPECT_TRUE(numbers) << it->str();
    strokes.push_back(stroke);
  }
  return strokes;
}

Point At(const Stroke& s, double t) {
  const auto mix = [&](double a, double b, double c, double d) {
    const double u = 1 - t;
    return u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d;
  };
  return {mix(s[0].x, s[1].x, s[2].x, s[3].x), mix(s[0].y, s[1].y, s[2].y, s[3].y)};
}

// The P-data of the picture, by its strokes alone: a gap between two of them is bridged from below. Where strokes meet, the polyline
// takes a short cut, so that bridges and strands cross inside edges.
std::string ReadPicture(const std::string& svg) {
  const std::vector<Stroke> strokes = StrokesOf(svg);
  if (strokes.empty()) return "no strokes";
  knot::Curve rope;
  const auto add = [&](Point p, int z) {
    rope.push_back({std::lround(p.x * 1e6), std::lround(-p.y * 1e6), z});  // in the picture y goes down
  };
  add(strokes.front()[0], 0);
  for (size_t k = 0; k < strokes.size(); ++k) {
    if (k > 0) {
      const Point from = strokes[k - 1][3], to = strokes[k][0];
      if (std::hypot(to.x - from.x, to.y - from.y) > 0.1) {
        add(from, -1);
        add(to, -1);
      }
    }
    for (int i = 1; i < 16; i += 2) add(At(strokes[k], i / 16.0), 0);
  }
  add(strokes.back()[3], 0);
  const auto read = knot::ProjectCurve(rope, knot::ViewFromAbove());
  const auto* fault = std::get_if<knot::CurveFault>(&read);
  return fault != nullptr ? fault->what() : std::get<knot::CurveProjection>(read).p.ToJson();
}

TEST(KnotDrawing, PicturesShowTheirPData) {
  EXPECT_EQ(ReadPicture(KnotSvg(PData())), PData().ToJson());
  EXPECT_EQ(ReadPicture(KnotSvg(kOverhand)), kOverhand.ToJson());
  for (const PData& p : knot::PlanarPData(1)) {
    for (const int outer : {0, 1}) EXPECT_EQ(ReadPicture(KnotSvg(p, Outside(outer))), p.ToJson());
  }
  std::mt19937_64 random(1);
  const PData p = knot::RandomPData(random, 8);
  EXPECT_EQ(ReadPicture(KnotSvg(p)), p.ToJson());
}

TEST(KnotDrawing, TheExactPictureShowsItsPData) {
  KnotDrawingOptions options;
  options.exact = true;
  for (const PData& p : {PData(), PData({2, 1}, {1, 2}), kOverhand})
    EXPECT_EQ(ReadPicture(KnotSvg(p, options)), p.ToJson());
}

TEST(KnotDrawing, IsWellFormedAndSaysWhatItShows) {
  const auto xml = ReadXml(KnotSvg(kOverhand));
  EXPECT_EQ(xml.error, "");
  EXPECT_EQ(xml.text, "A rope with 3 intersections");
  EXPECT_EQ(ReadXml(KnotSvg(PData({2, 1}, {1, 2}))).text, "A rope with 1 intersection");
  KnotDrawingOptions options;
  options.title = "a < b & c";
  const auto named = ReadXml(KnotSvg(kOverhand, options));
  EXPECT_EQ(named.error, "");
  EXPECT_EQ(named.text, "a < b & c");
}

// Seven segments and three intersections, numbered as in [thesis, 5.1.2].
TEST(KnotDrawing, LabelsNameSegmentsAndColumns) {
  KnotDrawingOptions options;
  options.labels = true;
  const auto xml = ReadXml(KnotSvg(kOverhand, options));
  EXPECT_EQ(xml.error, "");
  EXPECT_EQ(xml.elements.at("text"), 10);
  EXPECT_EQ(ReadXml(KnotSvg(kOverhand)).elements.count("text"), 0u);
  for (const std::string columns : {"1\u00b74", "2\u00b75", "3\u00b76"})
    EXPECT_NE(xml.text.find(columns), std::string::npos) << columns;
}

TEST(KnotDrawing, StaysWithinItsSize) {
  KnotDrawingOptions options;
  options.size = 200;
  const std::string svg = KnotSvg(kOverhand, options);
  std::smatch box;
  ASSERT_TRUE(std::regex_search(svg, box, std::regex("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"")));
  EXPECT_LE(std::stoi(box[1]), 200);
  EXPECT_LE(std::stoi(box[2]), 200);
  for (const Stroke& stroke : StrokesOf(svg)) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      EXPECT_GE(At(stroke, t).x, 0);
      EXPECT_LE(At(stroke, t).x, std::stoi(box[1]));
      EXPECT_GE(At(stroke, t).y, 0);
      EXPECT_LE(At(stroke, t).y, std::stoi(box[2]));
    }
  }
}

TEST(KnotDrawing, ATorusAndAFaceThatIsNoneAreRefused) {
  EXPECT_THROW(KnotSvg(PData({3, 4, 1, 2}, {3, 3, 4, 4})), PreconditionError);
  EXPECT_THROW(KnotSvg(kOverhand, Outside(4)), PreconditionError);
}

TEST(FullKnotDrawing, EveryPictureOf2ShowsItsPDataWithEachFaceOutside) {
  for (const PData& p : knot::PlanarPData(2)) {
    for (const int outer : {0, 1, 2}) EXPECT_EQ(ReadPicture(KnotSvg(p, Outside(outer))), p.ToJson());
  }
}

void ExpectPicturesOfRandomRopes(uint64_t seed, int crossings, int ropes) {
  std::mt19937_64 random(seed);
  for (int k = 0; k < ropes; ++k) {
    const PData p = knot::RandomPData(random, crossings);
    EXPECT_EQ(ReadPicture(KnotSvg(p)), p.ToJson());
  }
}

TEST(FullKnotDrawing, PicturesOfRandomRopesOfUpTo8ShowTheirPData) {
  ExpectPicturesOfRandomRopes(2, 4, 10);
  ExpectPicturesOfRandomRopes(3, 8, 10);
}

// The largest that has to be readable.
TEST(FullKnotDrawing, PicturesOfRandomRopesOf15And30ShowTheirPData) {
  ExpectPicturesOfRandomRopes(4, 15, 6);
  ExpectPicturesOfRandomRopes(5, 30, 6);
}

}  // namespace
}  // namespace tact::provers

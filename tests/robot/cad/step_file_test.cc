#include "robot/cad/step_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "algebra/error.h"
#include "robot/cad/mesh.h"

namespace tact::cad {
namespace {

using algebra::Polyhedron;
using algebra::Rational;
using algebra::SixfoldVolume;
using algebra::Vector3;

const std::string kFolder = std::string(TACT_SOURCE_DIR) + "/tests/robot/cad/step/";
constexpr LengthUnit kMm = LengthUnit::kMillimetre;

std::vector<std::string> Corners(const Polyhedron& solid) {
  std::vector<std::string> corners;
  for (const auto& v : solid.vertices) {
    corners.push_back(v.point.x.ToString() + " " + v.point.y.ToString() + " " + v.point.z.ToString());
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

std::vector<std::string> Planes(const Polyhedron& solid) {
  std::vector<std::string> planes;
  for (const auto& face : solid.faces) {
    planes.push_back(face.normal.x.ToString() + " " + face.normal.y.ToString() + " " +
                     face.normal.z.ToString() + " " + face.offset.ToString() + " " +
                     std::to_string(face.loops.front().size()));
  }
  std::sort(planes.begin(), planes.end());
  return planes;
}

// The prism over the L-shape (0,0) (3,0) (3,1) (1,1) (1,2) (0,2), 4 high: its volume is 16.
TEST(StepFile, TheFilesUnitCountsWhateverTheCallerSays) {
  for (const auto& [file, unit] :
       {std::pair{"l_prism_inch.step", LengthUnit::kInch}, {"l_prism_metre.step", LengthUnit::kMetre}}) {
    const Mesh mesh = ReadMesh(kFolder + file, kMm, unit);
    EXPECT_EQ(SixfoldVolume(mesh.solid), Rational(6 * 16)) << file;
    EXPECT_EQ(mesh.solid.faces.size(), 8U);
    EXPECT_EQ(mesh.solid.edges.size(), 18U);
    EXPECT_TRUE(mesh.notes.empty());
  }
  const Mesh inches = ReadMesh(kFolder + "l_prism_inch.step", LengthUnit::kInch, kMm);
  EXPECT_EQ(SixfoldVolume(inches.solid),
            Rational(6 * 16) * Rational(254, 10) * Rational(254, 10) * Rational(254, 10));
}

// A plate 8 x 4 x 2 with a hole 2 x 2 all through and a pocket 3 x 2, 1 deep: 64 - 8 - 6.
TEST(StepFile, FacesWithHolesStayFacesWithHoles) {
  const Mesh mesh = ReadMesh(kFolder + "frame.step", kMm, kMm);
  EXPECT_EQ(SixfoldVolume(mesh.solid), Rational(6 * 50));
  EXPECT_EQ(mesh.solid.vertices.size(), 24U);
  EXPECT_EQ(mesh.solid.faces.size(), 15U);
  std::vector<size_t> loops;
  for (const auto& face : mesh.solid.faces) loops.push_back(face.loops.size());
  std::sort(loops.rbegin(), loops.rend());
  EXPECT_EQ(loops[0], 3U);
  EXPECT_EQ(loops[1], 2U);
  EXPECT_EQ(loops[2], 1U);
}

// The L-prism turned by 0.7 about (1, 2, 3) and moved: no corner has a short decimal, yet every face is planar.
TEST(StepFile, APartThatLiesAskewHasPlanarFacesAndSaysSo) {
  const Mesh mesh = ReadMesh(kFolder + "l_prism_askew.step", kMm, kMm);
  EXPECT_EQ(mesh.solid.vertices.size(), 12U);
  EXPECT_EQ(mesh.solid.faces.size(), 8U);
  EXPECT_NEAR(ToDouble(SixfoldVolume(mesh.solid)), 96, 1e-5);
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_NE(mesh.notes[0].find("faces have no planar short decimals"), std::string::npos) << mesh.notes[0];
  const auto at = [&](double x, double y, double z) {
    return std::any_of(mesh.solid.vertices.begin(), mesh.solid.vertices.end(), [&](const auto& v) {
      const auto p = ToDouble(v.point);
      return std::hypot(p[0] - x, p[1] - y, p[2] - z) < 1e-6;
    });
  };
  EXPECT_TRUE(at(10, 20, 30.1));  // the origin, which the rotation keeps
}

TEST(StepFile, ThePublishedModelsEqualTheirPolygons) {
  const std::string folder = std::string(TACT_SOURCE_DIR) + "/../shared/data/peg_in_hole/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data here";
  for (const std::string model : {"peg", "hole"}) {
    const Mesh step = ReadMesh(folder + model + ".step", kMm, kMm),
               off = ReadMesh(folder + model + ".off", kMm, kMm);
    EXPECT_EQ(Corners(step.solid), Corners(off.solid)) << model;
    EXPECT_EQ(Planes(step.solid), Planes(off.solid)) << model;
    EXPECT_TRUE(step.notes.empty());
  }
}

}  // namespace
}  // namespace tact::cad

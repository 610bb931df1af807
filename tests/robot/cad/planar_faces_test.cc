#include "robot/cad/planar_faces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "algebra/error.h"

namespace tact::cad {
namespace {

using Eigen::Vector3d;

// A cube of side 2 about the origin, every corner passed through move.
template <typename Move>
std::vector<LoopedFace> Cube(Move move) {
  std::vector<LoopedFace> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      LoopedFace face;
      Vector3d n = Vector3d::Zero(), u = Vector3d::Zero();
      n[axis] = side;
      u[(axis + 1) % 3] = 1;
      const Vector3d v = n.cross(u);
      face.loops.push_back({move(n - u - v), move(n + u - v), move(n + u + v), move(n - u + v)});
      face.normal =
          (face.loops[0][1] - face.loops[0][0]).cross(face.loops[0][3] - face.loops[0][0]).normalized();
      face.name = "face " + std::to_string(faces.size() + 1);
      faces.push_back(face);
    }
  }
  return faces;
}

TEST(PlanarFaces, TheLastDigitsOfAKernelAreUndone) {
  int k = 0;
  const auto faces = Cube(
      [&](const Vector3d& p) -> Vector3d { return 52.5 * p + 1e-13 * (k++ % 3 - 1) * Vector3d(1, -1, 1); });
  const PlanarFaces planar = MakePlanar(faces, "cube");
  EXPECT_EQ(planar.soup.points.size(), 8U);
  EXPECT_EQ(SixfoldVolume(BuildPolyhedron(planar.soup)), algebra::Rational(6 * 105 * 105 * 105));
  EXPECT_TRUE(planar.notes.empty());
}

TEST(PlanarFaces, LoopsInEitherSenseFaceOutward) {
  auto faces = Cube([](const Vector3d& p) { return p; });
  std::reverse(faces[1].loops[0].begin(), faces[1].loops[0].end());
  EXPECT_EQ(SixfoldVolume(BuildPolyhedron(MakePlanar(faces, "cube").soup)), algebra::Rational(6 * 8));
}

// Any turn of a cube, whose corners all lie on three faces, becomes exactly planar near where it was.
TEST(PlanarFaces, ACubeAskewIsMovedBySoLittle) {
  size_t noted = 0;
  for (int k = 1; k < 20; ++k) {
    const Eigen::AngleAxisd turn(0.31 * k, Vector3d(1, k % 4, -2).normalized());
    const auto faces =
        Cube([&](const Vector3d& p) -> Vector3d { return turn * (30 * p) + Vector3d(0.1, 200, k); });
    const PlanarFaces planar = MakePlanar(faces, "cube");
    const auto solid = BuildPolyhedron(planar.soup);
    EXPECT_EQ(solid.faces.size(), 6U);
    EXPECT_NEAR(ToDouble(SixfoldVolume(solid)), 6 * 60 * 60 * 60, 1e-2);
    ASSERT_LE(planar.notes.size(), 1U);
    noted += planar.notes.size();
  }
  EXPECT_GT(noted, 5U);  // rounded corners may happen to be planar as they are
}

TEST(PlanarFaces, AFaceThatIsNotPlanarIsRefusedByName) {
  const Vector3d corner(1, 1, 1);
  const auto faces =
      Cube([&](const Vector3d& p) -> Vector3d { return p == corner ? p + Vector3d(0.01, 0, 0.02) : p; });
  try {
    MakePlanar(faces, "cube.step");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("cube.step: face "), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("mm off its plane"), std::string::npos) << error.what();
  }
}

TEST(PlanarFaces, HolesThatTouchTheRimAreRefused) {
  auto faces = Cube([](const Vector3d& p) { return p; });
  const auto& outer = faces[5].loops[0];  // z = 1
  faces[5].loops.push_back({outer[0], 0.5 * outer[1], 0.5 * outer[2]});
  for (auto& p : faces[5].loops[1]) p.z() = 1;
  EXPECT_THROW(MakePlanar(faces, "cube"), InputError);
}

}  // namespace
}  // namespace tact::cad

#include "robot/perception/range_image.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "algebra/error.h"
#include "robot/perception/plier.h"

namespace tact::perception {
namespace {

RangeCamera SmallCamera() {
  RangeCamera camera;
  camera.width = 40;
  camera.height = 30;
  camera.focal = 100;
  return camera;
}

// A square facing the camera, counter-clockwise as seen from there.
TriangleMesh Square(double half, double z) {
  return {{{-half, -half, z}, {-half, half, z}, {half, half, z}, {half, -half, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(RangeImage, APlaneIsSeenInEveryPixelAtItsDistance) {
  const std::vector<PosedMesh> scene = {{Square(1, 0.7), {}}};
  const LabelledPoints seen = TakeRangeImage(SmallCamera(), scene, 1);
  ASSERT_EQ(seen.points.size(), 40u * 30u);
  for (const Vector3d& p : seen.points) EXPECT_NEAR(p.z(), 0.7, 1e-14);
  // By hand: the first pixel's centre is 19.5 and 14.5 pixels from the middle, at 100 pixels a unit of slope.
  EXPECT_NEAR(seen.points[0].x(), -0.7 * 0.195, 1e-14);
  EXPECT_NEAR(seen.points[0].y(), -0.7 * 0.145, 1e-14);
}

TEST(RangeImage, WhatIsNearerHidesAndIsAsLargeAsItLooks) {
  // By hand: half a side of 0.0101 at 0.5 is 2.02 pixels: the four pixels by four whose centres lie within.
  const std::vector<PosedMesh> scene = {{Square(1, 0.7), {}}, {Square(0.0101, 0.5), {}}};
  const LabelledPoints seen = TakeRangeImage(SmallCamera(), scene, 1);
  std::map<int, int> counts;
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    ++counts[seen.meshes[i]];
    EXPECT_NEAR(seen.points[i].z(), seen.meshes[i] == 1 ? 0.5 : 0.7, 1e-14);
  }
  EXPECT_EQ(counts[1], 16);
  EXPECT_EQ(counts[0], 40 * 30 - 16);
}

TEST(RangeImage, AFaceFromBehindIsNotSeen) {
  TriangleMesh away = Square(1, 0.7);
  for (auto& triangle : away.triangles) std::swap(triangle[1], triangle[2]);
  EXPECT_TRUE(TakeRangeImage(SmallCamera(), std::vector<PosedMesh>{{away, {}}}, 1).points.empty());
}

// Of the lines through the origin: the least distance at which one meets a triangle's front [Moeller and Trumbore].
std::optional<double> Hit(const Vector3d& ray, const std::array<Vector3d, 3>& t) {
  const Vector3d e = t[1] - t[0], f = t[2] - t[0], h = ray.cross(f);
  const double determinant = e.dot(h);
  if (determinant <= 0) return std::nullopt;
  const Vector3d s = -t[0], q = s.cross(e);
  const double u = s.dot(h) / determinant, v = ray.dot(q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
  return f.dot(q) / determinant;
}

RC_GTEST_PROP(RangeImage, EveryPixelSeesWhatItsRayMeets, ()) {
  const auto coordinate = [] { return (*rc::gen::inRange(-1000, 1000)) / 5003.0; };
  TriangleMesh mesh;
  for (int i = 0; i < 12; ++i) mesh.points.emplace_back(coordinate(), coordinate(), 0.6 + coordinate());
  for (std::size_t i = 0; i < 12; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  RangeCamera camera = SmallCamera();
  camera.lost_from = camera.lost_surely = 2;  // never
  const LabelledPoints seen = TakeRangeImage(camera, std::vector<PosedMesh>{{mesh, {}}}, 1);
  std::size_t next = 0;
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& t : mesh.triangles) {
        const auto hit =
            Hit(camera.Ray(column, row), {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
        if (hit) nearest = std::min(nearest, *hit);
      }
      if (nearest == std::numeric_limits<double>::infinity()) continue;
      RC_ASSERT(next < seen.points.size());
      RC_ASSERT((seen.points[next++] - nearest * camera.Ray(column, row)).norm() < 1e-9);
    }
  }
  RC_ASSERT(next == seen.points.size());
}

TEST(RangeImage, NoiseLiesAlongTheRayAndFollowsTheSeed) {
  RangeCamera camera = SmallCamera();
  camera.noise = 1e-3;
  const std::vector<PosedMesh> scene = {{Square(1, 0.7), {}}};
  const LabelledPoints seen = TakeRangeImage(camera, scene, 1);
  double squares = 0;
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    const Vector3d ray = camera.Ray(static_cast<int>(i) % 40, static_cast<int>(i) / 40);
    EXPECT_LT(ray.cross(seen.points[i]).norm(), 1e-14);
    squares += std::pow(seen.points[i].norm() - 0.7 * ray.norm(), 2);
  }
  // 1200 values: the deviation found is within 10 % (five of its own deviations) of 1 mm.
  EXPECT_NEAR(std::sqrt(squares / 1200), 1e-3, 1e-4);
  EXPECT_EQ(seen.points, TakeRangeImage(camera, scene, 1).points);
  EXPECT_NE(seen.points, TakeRangeImage(camera, scene, 2).points);
}

TEST(RangeImage, RaysAtAFlatAngleAreLost) {
  RangeCamera camera = SmallCamera();
  camera.focal = 4000;  // so narrow that all rays meet the plane at almost the same angle
  const auto share = [&](double degrees) {
    const Transform tilted{joint::RotationExp({0, degrees * M_PI / 180, 0}), Vector3d(0, 0, 0.7)};
    return static_cast<double>(
               TakeRangeImage(camera, std::vector<PosedMesh>{{Square(0.2, 0), tilted}}, 1).points.size()) /
           (40 * 30);
  };
  EXPECT_EQ(share(60), 1);
  EXPECT_NEAR(share(77.35), 0.5, 0.075);  // halfway between 1.22 and 1.48; 1200 rays, five deviations
  EXPECT_EQ(share(87), 0);
}

TEST(RangeImage, RefusesWhatItCannotLookAt) {
  RangeCamera blind;
  blind.width = 0;
  EXPECT_THROW(TakeRangeImage(blind, {}, 1), PreconditionError);
  const std::vector<PosedMesh> behind = {{Square(1, -0.7), {}}};
  EXPECT_THROW(TakeRangeImage(SmallCamera(), behind, 1), PreconditionError);
  TriangleMesh broken = Square(1, 0.7);
  broken.triangles[0][0] = 4;
  EXPECT_THROW(TakeRangeImage(SmallCamera(), std::vector<PosedMesh>{{broken, {}}}, 1), PreconditionError);
}

TEST(Plier, ItsLeverIsClosedAndIsAPlierLong) {
  const TriangleMesh lever = PlierLever();
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  double volume = 0;
  for (const auto& t : lever.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    volume += lever.points[t[0]].dot(lever.points[t[1]].cross(lever.points[t[2]])) / 6;
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
  EXPECT_GT(volume, 0);  // faces outward
  double low = 0, high = 0;
  for (const Vector3d& p : lever.points) low = std::min(low, p.x()), high = std::max(high, p.x());
  EXPECT_NEAR(high - low, 0.150, 0.01);
}

TEST(Plier, ItsHandlesPartAsItOpens) {
  const auto gap = [](double opening) {
    const std::vector<PosedMesh> plier = OpenPlier({}, opening);
    return (plier[0].X_CM * plier[0].mesh.points[0] - plier[1].X_CM * plier[1].mesh.points[0]).norm();
  };
  // By hand: the handles' ends lie at r = hypot(99, 23) mm from the pin, 2 atan(23 / 99) apart.
  EXPECT_NEAR(gap(0), 0.046, 1e-12);
  EXPECT_NEAR(gap(0.5), 2 * std::hypot(0.099, 0.023) * std::sin(std::atan(23.0 / 99) + 0.25), 1e-12);
}

}  // namespace
}  // namespace tact::perception

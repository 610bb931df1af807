#include "robot/perception/range_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/error.h"
#include "robot/perception/random_numbers.h"

namespace tact::perception {
namespace {

struct Pixel {
  double depth = std::numeric_limits<double>::infinity();  // along z
  double cosine = 0;                                       // of the angle between ray and normal
  int mesh = -1;
};

// Columns or rows whose pixels' centres may lie between two coordinates in the image plane, in pixels.
struct Span {
  int first, last;
};
Span SpanOf(double low, double high, int size) {
  return {std::clamp(static_cast<int>(std::floor(low - 0.5)), 0, size),
          std::clamp(static_cast<int>(std::ceil(high - 0.5)) + 1, 0, size)};
}

class DepthBuffer {
 public:
  explicit DepthBuffer(const RangeCamera& camera)
      : camera_(camera),
        pixels_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)) {}

  void Draw(const std::array<Vector3d, 3>& corners, int mesh) {
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double distance = normal.dot(corners[0]);
    if (!(distance < 0)) return;  // the camera is behind the face
    // A ray passes inside if it lies on one side of the planes through the camera and each edge.
    const std::array<Vector3d, 3> edges = {corners[1].cross(corners[0]), corners[2].cross(corners[1]),
                                           corners[0].cross(corners[2])};
    const auto [columns, rows] = Bounds(corners);
    for (int row = rows.first; row < rows.last; ++row) {
      for (int column = columns.first; column < columns.last; ++column) {
        const Vector3d ray = camera_.Ray(column, row);
        if (edges[0].dot(ray) < 0 || edges[1].dot(ray) < 0 || edges[2].dot(ray) < 0) continue;
        const double along = normal.dot(ray), depth = distance / along;
        Pixel& pixel = At(column, row);
        if (!(along < 0) || depth >= pixel.depth) continue;
        pixel = {depth, -along / (normal.norm() * ray.norm()), mesh};
      }
    }
  }

  Pixel& At(int column, int row) {
    return pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width) +
                   static_cast<std::size_t>(column)];
  }

 private:
  std::pair<Span, Span> Bounds(const std::array<Vector3d, 3>& corners) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Eigen::Vector2d low(kInfinity, kInfinity), high(-kInfinity, -kInfinity);
    for (const Vector3d& p : corners) {
      const Eigen::Vector2d at =
          p.head<2>() * (camera_.focal / p.z()) + Eigen::Vector2d(camera_.width, camera_.height) / 2;
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    return {SpanOf(low.x(), high.x(), camera_.width), SpanOf(low.y(), high.y(), camera_.height)};
  }

  const RangeCamera& camera_;
  std::vector<Pixel> pixels_;
};

void Draw(const PosedMesh& posed, int mesh, DepthBuffer* buffer) {
  std::vector<Vector3d> points_C;
  points_C.reserve(posed.mesh.points.size());
  for (const Vector3d& p : posed.mesh.points) {
    points_C.push_back(posed.X_CM * p);
    if (!(points_C.back().z() > 0)) throw PreconditionError("a point is at or behind the camera's centre");
  }
  for (const auto& triangle : posed.mesh.triangles) {
    for (const std::size_t corner : triangle) {
      if (corner >= points_C.size()) throw PreconditionError("a triangle refers to no point of its mesh");
    }
    buffer->Draw({points_C[triangle[0]], points_C[triangle[1]], points_C[triangle[2]]}, mesh);
  }
}

}  // namespace

LabelledPoints TakeRangeImage(const RangeCamera& camera, std::span<const PosedMesh> scene,
                              std::uint64_t seed) {
  if (camera.width < 1 || camera.height < 1 || !(camera.focal > 0))
    throw PreconditionError("a camera needs pixels and a focal length");
  DepthBuffer buffer(camera);
  for (std::size_t i = 0; i < scene.size(); ++i) Draw(scene[i], static_cast<int>(i), &buffer);
  LabelledPoints seen;
  RandomNumbers random(seed);
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const Pixel& pixel = buffer.At(column, row);
      if (pixel.mesh < 0) continue;
      const double angle = std::acos(std::min(1.0, pixel.cosine));
      const double lost = (angle - camera.lost_from) / (camera.lost_surely - camera.lost_from);
      const double chance = random.Uniform(), noise = random.Gaussian();
      if (chance < lost) continue;
      const Vector3d ray = camera.Ray(column, row);
      seen.points.push_back(ray * (pixel.depth + camera.noise * noise / ray.norm()));
      seen.meshes.push_back(pixel.mesh);
    }
  }
  return seen;
}

}  // namespace tact::perception

/// @file
/// Range images of solids, as a laser range finder takes them: a pinhole camera that measures along each pixel's ray.
/// Model   The nearest front face along the ray, at a distance to which Gaussian noise is added. A ray that meets the face
///         at too flat an angle is lost: with a chance that rises from 0 to 1 between two angles off the face's normal.
///         Left out: the shadow of the laser, mixed pixels at edges, errors that neighbouring pixels share.
/// Frames  camera C: x to the right, y down, z forward; its centre is the origin.
/// Units   metre, radian; the focal length in pixels.
/// Exact   no. The same seed gives the same image.
/// Errors  PreconditionError: a camera without pixels or of no focal length, a triangle that refers to no point, a point at
///         or behind the camera's centre.
/// Cost    O(pixels that the triangles' bounding boxes cover).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "robot/joint/transform.h"

namespace tact::perception {

using Eigen::Vector3d;
using joint::Transform;

/// Corners run counter-clockwise as seen from outside.
struct TriangleMesh {
  std::vector<Vector3d> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// A mesh in its place.
struct PosedMesh {
  TriangleMesh mesh;
  Transform X_CM;
};

/// Of the class of a Vivid 910 with its middle lens: 0.2 m wide at 0.6 m.
struct RangeCamera {
  int width = 640, height = 480;
  double focal = 1940;
  double noise = 0;                             // standard deviation along the ray
  double lost_from = 1.22, lost_surely = 1.48;  // angles between ray and normal: 70 and 85 degrees

  /// Through the centre of a pixel, counted from 0; z is 1.
  Vector3d Ray(int column, int row) const {
    return {(column + 0.5 - width / 2.0) / focal, (row + 0.5 - height / 2.0) / focal, 1};
  }
};

/// Points in the order of the image's rows, each with the mesh that it lies on, counted from 0.
struct LabelledPoints {
  std::vector<Vector3d> points;
  std::vector<int> meshes;
};

/// What the camera measures of the scene.
LabelledPoints TakeRangeImage(const RangeCamera& camera, std::span<const PosedMesh> scene,
                              std::uint64_t seed);

}  // namespace tact::perception

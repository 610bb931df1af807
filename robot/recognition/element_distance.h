/// @file
/// Distances between the elements of two solids in doubles: which point contacts could be, and how far they are.
/// Model   A vertex and a face are as far apart as the vertex and the nearest point of the face (its loops enclose it),
///         two edges as their nearest points. A pair counts only if it can touch: the solid at the vertex lies outside the
///         face's plane, up to an angle; the solids at two crossing edges lie on either side of the plane through both, and
///         their crossing is farther from all four ends than the limit, for nearer to an end the vertex says it.
/// Frames  F; X_FM is the moving solid's pose in it.
/// Units   the solids'.
/// Cost    V F + E^2 tests of a few dozen flops; 41 poses of the recorded peg take milliseconds.
#pragma once

#include <array>
#include <vector>

#include "robot/recognition/point_contact.h"

namespace tact::recognition {

/// A solid prepared for distances; indices as in the polyhedron.
class ProximitySolid {
 public:
  explicit ProximitySolid(const algebra::Polyhedron& solid);

  const SolidF& solid() const { return solid_; }
  /// Unit directions of the edges that leave a vertex.
  const std::vector<Eigen::Vector3d>& edges_at(size_t vertex) const { return edges_at_[vertex]; }
  /// Unit directions into both faces at an edge, square to it.
  const std::array<Eigen::Vector3d, 2>& wings(size_t edge) const { return wings_[edge]; }
  bool is_convex(size_t edge) const { return convex_[edge]; }
  /// The vertices of an edge, and of a face's loops.
  const std::array<size_t, 2>& ends(size_t edge) const { return ends_[edge]; }
  const std::vector<std::vector<size_t>>& loops(size_t face) const { return loops_[face]; }
  /// From a point, in the solid's frame, to the nearest point of the face.
  double DistanceToFace(size_t face, const Eigen::Vector3d& p) const;
  /// To the nearest point of the surface, from inside or outside.
  double DistanceToSurface(const Eigen::Vector3d& p) const;
  /// How deep a point, in the solid's frame, lies inside it; 0 outside. A point nearly on the surface may count as either.
  double DepthOf(const Eigen::Vector3d& p) const;

 private:
  // Whether a point of the face's plane lies within its loops.
  bool Encloses(size_t face, const Eigen::Vector3d& foot) const;

  SolidF solid_;
  std::vector<std::vector<Eigen::Vector3d>> edges_at_;
  std::vector<std::array<Eigen::Vector3d, 2>> wings_;
  std::vector<bool> convex_;
  std::vector<std::array<size_t, 2>> ends_;
  std::vector<std::vector<std::vector<size_t>>> loops_;
};

/// Between two segments.
double DistanceOfSegments(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                          const Eigen::Vector3d& d);

struct NearPair {
  PointContact contact;
  double distance = 0;  // between the elements, not negative
  double gap = 0;       // signed, as GapOf says it
};

/// Pairs nearer than limit, sorted by contact; most_tilt: radian, how far the solid may seem to dip into the other's plane.
std::vector<NearPair> NearPairs(const ProximitySolid& moving, const ProximitySolid& fixed,
                                const joint::Transform& X_FM, double limit, double most_tilt);

}  // namespace tact::recognition

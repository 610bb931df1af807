/// @file
/// A solid in doubles, prepared for distances: from its faces and its surface, and what lies at its vertices and edges.
/// Frames  points in the solid's frame.
/// Units   the solid's.
/// Exact   no.
/// Cost    a face's distance O(corners); depth O(faces corners).
#pragma once

#include <array>
#include <vector>

#include "robot/recognition/point_contact.h"

namespace tact::recognition {

/// Indices as in the polyhedron.
class ProximitySolid {
 public:
  explicit ProximitySolid(const algebra::Polyhedron& solid);

  const SolidF& solid() const { return solid_; }
  /// Unit directions of the edges that leave a vertex.
  const std::vector<Eigen::Vector3d>& edges_at(size_t vertex) const { return edges_at_[vertex]; }
  const std::vector<size_t>& faces_at(size_t vertex) const { return faces_at_[vertex]; }
  /// Unit directions into both faces at an edge, square to it.
  const std::array<Eigen::Vector3d, 2>& wings(size_t edge) const { return wings_[edge]; }
  bool is_convex(size_t edge) const { return convex_[edge]; }
  /// The middle of the bounding box, and the largest distance of two vertices.
  Eigen::Vector3d middle() const;
  double diameter() const;

  /// How far the foot of a point on the face's plane lies outside the face; zero within.
  double AsideOfFace(size_t face, const Eigen::Vector3d& p) const;
  /// To the nearest point of the face.
  double DistanceToFace(size_t face, const Eigen::Vector3d& p) const;
  /// To the nearest point of the surface, from inside or outside.
  double DistanceToSurface(const Eigen::Vector3d& p) const;
  /// How deep a point lies inside; 0 outside. A point nearly on the surface may count as either.
  double DepthOf(const Eigen::Vector3d& p) const;

 private:
  // Whether a point of the face's plane lies within its loops.
  bool Encloses(size_t face, const Eigen::Vector3d& foot) const;

  SolidF solid_;
  std::vector<std::vector<Eigen::Vector3d>> edges_at_;
  std::vector<std::vector<size_t>> faces_at_;
  std::vector<std::array<Eigen::Vector3d, 2>> wings_;
  std::vector<bool> convex_;
  std::vector<std::vector<std::vector<size_t>>> loops_;
};

}  // namespace tact::recognition

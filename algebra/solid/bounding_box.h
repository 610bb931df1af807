/// @file
/// Boxes along the axes that surely hold exact points: for leaving out what is too far, never for a decision.
/// Model   bounds in doubles, rounded outwards.
#pragma once

#include <array>

#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

struct BoundingBox {
  std::array<double, 3> low, high;

  /// Holds nothing.
  BoundingBox();
  void Add(const Vector3& point);
  void Add(const BoundingBox& other);
  bool Overlaps(const BoundingBox& other) const { return Near(other, 0); }
  /// Whether some point of this box may be within the distance of some point of the other along every axis.
  bool Near(const BoundingBox& other, double distance) const;
  /// At most the squared distance between points of the two boxes.
  double SquaredDistanceBelow(const BoundingBox& other) const;
};

BoundingBox BoxOf(const Vector3& point);
BoundingBox BoxOf(const Polyhedron& solid);
/// Of each face.
std::vector<BoundingBox> FaceBoxes(const Polyhedron& solid);

}  // namespace tact::algebra

/// @file
/// Where points lie, many of them for one solid: faces whose box rules them out are not looked at.
/// Exact   every decision; boxes in doubles only leave faces out.
/// Cost    a box test a face, exact arithmetic for the few that a ray from the point may meet.
#pragma once

#include <array>
#include <vector>

#include "algebra/solid/bounding_box.h"

namespace tact::algebra {

/// Keeps a reference to the solid.
class PointLocator {
 public:
  explicit PointLocator(const Polyhedron& solid);
  /// As algebra::Locate.
  Side Locate(const Vector3& point) const;
  /// Squared distance to the nearest face, if it is more than `enough`; otherwise some value that is not.
  Rational SquaredDistanceToSurface(const Vector3& point, const Rational& enough) const;

 private:
  // A face's plane in doubles: unit normal . p = offset.
  struct Plane {
    std::array<double, 3> normal;
    double offset;
  };

  double SquaredDistanceBelow(size_t face, const BoundingBox& here) const;

  const Polyhedron& solid_;
  std::vector<BoundingBox> boxes_;
  std::vector<Plane> planes_;
};

}  // namespace tact::algebra

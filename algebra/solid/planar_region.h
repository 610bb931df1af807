/// @file
/// Plane regions in space, bounded by straight loops: where a point lies, where a segment meets one.
/// Model   a region is what an odd number of its loops encloses; loops may touch one another.
/// Exact   rational coordinates; no tolerance anywhere.
/// Cost    O(corners) per query.
#pragma once

#include <optional>
#include <vector>

#include "algebra/screw/vector3.h"
#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

/// Two coordinate axes onto which a plane is projected so that counter-clockwise about its normal stays so.
struct Axes {
  int u = 0, v = 1;
};
Axes ProjectionAxes(const Vector3& normal);

/// 1 if a, b, c turn counter-clockwise in the projection, -1 if clockwise, 0 if they are collinear.
int Orientation(Axes axes, const Vector3& a, const Vector3& b, const Vector3& c);

/// Points are referred to, not owned.
struct PlanarRegion {
  Vector3 normal;
  Rational offset;
  Axes axes;
  std::vector<std::vector<const Vector3*>> loops;

  /// normal . point - offset.
  Rational Height(const Vector3& point) const { return Dot(normal, point) - offset; }
};

/// Twice the area that a loop encloses, along the normal about which it runs counter-clockwise.
Vector3 DoubleArea(const std::vector<const Vector3*>& loop);

PlanarRegion RegionOf(const Polyhedron& solid, const Face& face);

/// Six times the signed volume of the cone from the origin to the region.
Rational SixfoldVolumeUnder(const PlanarRegion& region);

/// Where a point of the region's plane lies.
Side LocateInPlane(const PlanarRegion& region, const Vector3& point);

/// A point that two segments of one plane share and that is no end of both; nullopt for equal segments.
std::optional<Vector3> UnsharedPoint(Axes axes, const Vector3& a, const Vector3& b, const Vector3& c,
                                     const Vector3& d);

/// A point of the segment ab in the closed region, other than a corner of the region that is an end of ab;
/// nullopt for a boundary edge that meets the rest of the boundary at its ends only.
std::optional<Vector3> UnsharedPoint(const PlanarRegion& region, const Vector3& a, const Vector3& b);

/// Whether the closed segment ab meets the closed region.
bool Meets(const PlanarRegion& region, const Vector3& a, const Vector3& b);

}  // namespace tact::algebra

/// @file
/// Exact squared distances and nearest points between points, segments and polygonal faces.
/// Exact   rational; distances stay squared.
/// Units   the coordinates' length unit, squared for distances.
#pragma once

#include "algebra/solid/bounding_box.h"
#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

/// The point of segment [a, b], a != b, nearest to p; parameter in [0, 1] from a to b.
struct SegmentPoint {
  Vector3 point;
  Rational parameter;
};
SegmentPoint NearestOnSegment(const Vector3& p, const Vector3& a, const Vector3& b);

/// Nearest points of two segments whose lines are not parallel.
struct SegmentPair {
  SegmentPoint first, second;
};
SegmentPair NearestOnSegments(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/// The projection of p onto the face's plane.
Vector3 ProjectOntoPlane(const Vector3& p, const Face& face);

/// Whether a point of the face's plane lies in the face, its boundary counted in. Exact crossing parity.
bool FaceContains(const Polyhedron& solid, const Face& face, const Vector3& point);

Rational SquaredDistance(const Vector3& a, const Vector3& b);
Rational SquaredDistanceToFace(const Polyhedron& solid, const Face& face, const Vector3& point);

/// Distances to a solid's surface, many of them: faces whose box is too far are not looked at. Keeps a reference to the solid.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const Polyhedron& solid);
  /// Squared, to the nearest face.
  Rational Squared(const Vector3& point) const;

 private:
  const Polyhedron& solid_;
  std::vector<BoundingBox> boxes_;
};

}  // namespace tact::algebra

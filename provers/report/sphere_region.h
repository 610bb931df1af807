/// @file
/// The legal translations of a non-singular contact relation as a region of the sphere of directions, cut up for a view.
/// Model   A direction v is legal if n . v >= 0 for all normals n, and maintaining if n . v = 0 for all of them
///         [thesis, 2.2].
/// Exact   every decision; a view's numbers count as the decimals they print as.
/// Errors  PreconditionError: a singular contact, one without planes, a zero normal.
#pragma once

#include <string>
#include <vector>

#include "algebra/contact/contact_relation.h"
#include "provers/report/projection.h"

namespace tact::provers {

/// The ten kinds of region, by the dimensions of the cone of legal translations and of its largest linear
/// subspace.
enum class SphereRegion {
  kWholeSphere,
  kHemisphere,
  kLune,
  kConvexPolygon,
  kGreatCircle,
  kHalfCircle,
  kArc,
  kOppositePoints,
  kPoint,
  kNothing
};

/// "lune", for captions.
std::string NameOf(SphereRegion region);

SphereRegion LegalDirections(const algebra::ContactRelation& relation);

/// What of a set of directions lies in one octant of a view: a point, an arc of at most a quarter circle, or a convex
/// polygon with its corners in order about it.
struct SpherePiece {
  std::vector<algebra::Vector3> corners;  // lengths mean nothing
  /// Whether the arc to the next corner is on the border of the set, not of the octant alone.
  std::vector<bool> border;
  /// Toward the viewer. Pieces on the sphere's outline count as such.
  bool front = false;
};

/// A set of directions in pieces as large as the whole: an area is given by polygons, a curve by arcs.
struct SphereSet {
  size_t dimension = 0;  // of the cone: 3 for areas, 2 for curves, 1 for points, 0 for nothing
  std::vector<SpherePiece> pieces;
};

struct SphereSets {
  SphereSet legal, maintaining;
};
/// PreconditionError: also a useless view.
SphereSets CutIntoPieces(const algebra::ContactRelation& relation, const View& view);

}  // namespace tact::provers

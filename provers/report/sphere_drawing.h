/// @file
/// The sphere of directions with the legal translations of a non-singular contact relation, as SVG.
/// Model   A direction v is legal if n . v >= 0 for all normals n, and maintaining if n . v = 0 for all of them
///         [thesis, 2.2]. What is legal is one of ten kinds of region. Legal directions are green, maintaining ones red;
///         on the far side of the sphere areas are paler, lines dashed, points hollow.
/// Exact   the kind, what is on the far side, and where the region is cut by the sphere's outline; the rest is drawing.
#pragma once

#include <string>

#include "algebra/contact/contact_relation.h"
#include "provers/report/projection.h"

namespace tact::provers {

/// By the dimensions of the cone of legal translations and of its largest linear subspace.
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

/// PreconditionError: a singular contact, one without planes, a zero normal.
SphereRegion LegalDirections(const algebra::ContactRelation& relation);

/// From the front right, above, so that no axis hides behind the sphere.
inline constexpr View kSphereView = {{0.8, -1, 0.62}, {0, 0, 1}, 280, 280};

/// One <svg> element without caption, for Figure. PreconditionError: as above, a useless view.
std::string DrawLegalDirections(const algebra::ContactRelation& relation, const View& view = kSphereView);

}  // namespace tact::provers

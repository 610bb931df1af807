/// @file
/// The sphere of directions with the legal translations of a non-singular contact relation, as SVG.
/// Model   Legal directions are green, maintaining ones red; on the far side of the sphere areas are paler, lines
///         dashed, points hollow.
/// Exact   what is drawn, and what of it is on the far side: see sphere_region.h.
#pragma once

#include <string>

#include "algebra/contact/contact_relation.h"
#include "provers/report/projection.h"
#include "provers/report/sphere_region.h"

namespace tact::provers {

/// From the front right, above, so that no axis hides behind the sphere.
inline constexpr View kSphereView = {{0.8, -1, 0.62}, {0, 0, 1}, 280, 280};

/// One <svg> element without caption, for Figure. PreconditionError: a singular contact, one without
/// planes, a zero normal, a useless view.
std::string DrawLegalDirections(const algebra::ContactRelation& relation, const View& view = kSphereView);

}  // namespace tact::provers

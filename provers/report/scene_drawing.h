/// @file
/// Drawings of a scene: the solids at one end of the motion, the moving one's outline at the other.
#pragma once

#include <string>

#include "algebra/contact/scene.h"
#include "provers/report/solid_drawing.h"

namespace tact::provers {

/// s is 0 or 1; the relation is the one there.
std::string DrawScene(const algebra::Scene& scene, int s, const algebra::ContactRelation& relation,
                      const View& view = {});

}  // namespace tact::provers

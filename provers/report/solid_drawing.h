/// @file
/// Drawings of polyhedra in contact, as SVG.
/// Model   The moving solid is drawn solid, the fixed one translucent with its far walls shown; concave edges are thick and
///         purple. A round blue dot is a contact with one separate plane, a magenta diamond a singular one; hollow ones lie
///         behind the moving solid. An arrow is a separate plane's normal, to its legal side; one along the line of
///         sight is a ring with a dot (toward the viewer) or a cross (away).
#pragma once

#include <string>
#include <vector>

#include "algebra/contact/contact_relation.h"
#include "algebra/solid/polyhedron.h"
#include "provers/report/projection.h"

namespace tact::provers {

/// A wall is part of a fixed solid's surface, translucent from both sides, with thin edges; an outline is its
/// edges alone, dotted.
enum class Part { kMoving, kFixed, kWall, kOutline };

/// A solid where it is: solids and relation are in one frame. Walls and outlines need not be closed.
struct DrawnSolid {
  algebra::Polyhedron solid;
  Part part = Part::kFixed;
};

/// One <svg> element without caption, for Figure. PreconditionError: a zero normal, a useless view.
std::string DrawContactRelation(const std::vector<DrawnSolid>& solids,
                                const algebra::ContactRelation& relation, const View& view = {});

}  // namespace tact::provers

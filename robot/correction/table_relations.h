/// @file
/// Contact relations for [thesis, 2.8.3, Table 2.1], whose Fig. 2.27 is lost: a peg and a block with a slot.
/// Model   The text leaves the restricted DOFs, translation and rotation. The linear method's printed mean turns are those of
///         a random turn's component along one axis (5/4 degree: A), across one axis (5 pi/8: B) and all of it (5/2: C); so
///         the rotation is restricted by 1, 2 and 3. Its printed shifts are those of a random shift along one axis (A) and
///         across one (B, C); so the translation is by 1, 2 and 2. Which contacts restrict so is our choice:
///           A       the peg's lower edge on the block's top
///           B       that edge on the rim of the slot, parallel (singular)
///           B slot  the peg jammed in the slot: an edge on one wall, its face on the other wall's rim
///           C       the peg upright in the slot's corner: on the floor, along a wall
///           C seated  the same in a slot that fits: on the floor, along both walls
/// Units   millimetre.
/// Exact   the solids and the realisations.
#pragma once

#include <string>
#include <vector>

#include "algebra/contact/contact_finder.h"
#include "robot/correction/contact_problem.h"

namespace tact::correction {

struct TableRelation {
  std::string name;
  algebra::Polyhedron moving, fixed;
  algebra::Pose realisation;
  algebra::FoundContacts found;  // there
};

/// Names as above.
TableRelation TableRelationNamed(const std::string& name);
std::vector<std::string> TableRelationNames();

/// The same with the moving frame's origin in the middle of the contacts. Noise turns about the origin, and a location is the
/// origin's: where the thesis' objects have theirs is lost.
TableRelation WithOriginAtContacts(TableRelation table);
Relation RelationOf(const TableRelation& table);

}  // namespace tact::correction

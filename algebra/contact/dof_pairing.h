/// @file
/// Which direction of motion becomes what: the DOF-transitions between two contact relations, direction by direction.
/// Model   A relation filters the directions of a motion: those that keep every contact, inside those whose span is
///         legal, inside all three. Two filtrations of one space have a common basis, and how many of its vectors are
///         of kind i before and of kind j after does not depend on the choice of it [Jordan-Hoelder; Zassenhaus 1934]:
///           n_ij = D(i, j) - D(i-1, j) - D(i, j-1) + D(i-1, j-1),  D(i, j) = dim(before_i cap after_j).
///         So the pairing that the counts alone leave open [thesis, 2.3.1] is decided by geometry. Directions of
///         rotation are axis directions. Of a singular relation, the non-singular contacts count [thesis, eq. (2.8)].
/// Frames  both relations in one frame, at (the limit of) one configuration.
#pragma once

#include <array>
#include <vector>

#include "algebra/contact/dof_transition.h"
#include "algebra/exact/integer_matrix.h"

namespace tact::algebra {

/// [from][to]: how many directions are of index `from` before and of index `to` after; they add up to three.
using DofPairing = std::array<std::array<int, kDofIndices>, kDofIndices>;

/// Bases of the directions that keep every contact, and of those that the legal ones span.
struct DirectionFiltration {
  std::array<IntegerMatrix, 2> spaces;  // three columns
  bool singular = false;
};

DirectionFiltration FilterDirections(const ContactRelation& relation, Motion motion);

DofPairing PairByDirection(const DirectionFiltration& before, const DirectionFiltration& after);
DofPairing PairByDirection(const ContactRelation& before, const ContactRelation& after, Motion motion);

/// The DOF-transitions of both motions by direction, translation first, each kind once, by from, then to.
std::vector<DofTransition> DofTransitionsByDirection(const ContactRelation& before,
                                                     const ContactRelation& after);

/// Those that the counts alone force: in every way to pair what falls with what rises, the pair occurs.
std::vector<DofTransition> ForcedDofTransitions(const MotionDof& before, const MotionDof& after);

/// The rules of [thesis, 2.6]; where the counts leave a choice of pairs (`ambiguous`), on the DOF-transitions by direction.
Transition AnalyzeTransition(const ContactRelation& before, const ContactRelation& after);

}  // namespace tact::algebra

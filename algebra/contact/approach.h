/// @file
/// A contact relation just before a motion ends in another one: its motion DOFs there, and the limit of its directions.
/// Model   Along the motion the contacts' rows are polynomials in its parameter s: of a vertex or a crossing of edges, and of
///         the normal of a fixed face, of a moving face, or the product of two edges' directions. Motion DOFs depend on
///         the signs of the rows' minors. These have integer coefficients of at most H, the product of the six largest sums
///         of a row's coefficients, hence no root in (0, 1 / (1 + H)) [Cauchy]: any s in there shows the relation near
///         the end. While the same elements touch, the motion DOFs may well change further away, as points move.
///         The directions kept are the solutions of a system of such rows with three unknowns; their limit at s = 0 is that of
///         the same row space with a basis whose values at 0 are independent. Setting s = 0 in the rows themselves would
///         lose what they say together when their normals become parallel there.
/// Frames  the fixed solid's.
/// Exact   polynomials with rational coefficients.
/// Errors  InvariantError: a contact that no pair of elements explains.
/// Cost    about a third of a millisecond.
#pragma once

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/dof_pairing.h"
#include "algebra/contact/motion_path.h"

namespace tact::algebra {

struct Approach {
  ContactRelation relation;                       // near the end
  std::array<DirectionFiltration, 2> directions;  // in translation, in rotation: the limit at the end
};

/// The moving solid is given as it is at the end, s = 0; `contacts` are those at s = 1. Precondition: the same pairs of
/// elements touch for all s in (0, 1].
Approach ApproachEnd(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path,
                     const FoundContacts& contacts);

}  // namespace tact::algebra

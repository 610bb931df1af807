/// @file
/// The directions that a contact relation keeps and permits, in the limit of a motion that ends in another relation.
/// Model   Along the motion the contacts' rows are polynomials in its parameter s: of a vertex or a crossing of edges, and of
///         the normal of a fixed face, of a moving face, or the product of two edges' directions. The directions kept
///         are the solutions of a system of such rows with three unknowns; their limit at s = 0 is that of the same row
///         space with a basis whose values at 0 are independent. Setting s = 0 in the rows themselves would lose what they
///         say together when their normals become parallel there.
/// Frames  the fixed solid's.
/// Exact   polynomials with rational coefficients.
/// Errors  InvariantError: a contact that no pair of elements explains.
#pragma once

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/dof_pairing.h"
#include "algebra/contact/motion_path.h"

namespace tact::algebra {

/// Both motions' filtrations at s = 0 of the relation that holds for s in (0, 1]. The moving solid is given as it is at
/// s = 0; `contacts` are those at s = 1. Preconditions: the same pairs of elements touch for all s in (0, 1]; of its
/// rows, the same vanish on all legal motions.
std::array<DirectionFiltration, 2> LimitDirections(const Polyhedron& moving, const Polyhedron& fixed,
                                                   const MotionPath& path, const FoundContacts& contacts);

}  // namespace tact::algebra

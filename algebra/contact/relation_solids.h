/// @file
/// Two real solids that touch in a given non-singular contact relation: a block in the cavity of a cage.
/// Model   A contact may slide along its line of action: its row [ p x n | n ] stays the same. Every direction of
///         normals is a plane wall of the cavity, at a distance near T from a centre; every contact slides onto its
///         wall. Once T is large enough all of them lie strictly inside every other wall, and the block is the convex
///         hull of these points and of a cube about the centre that touches nothing. T is the first that will do of
///         a sequence that doubles.
/// Frames  the solids and both relations in one frame, that of the relation given.
/// Exact   every decision, the square roots' rounding included; no tolerance.
#pragma once

#include "algebra/contact/contact_relation.h"
#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

struct RelationSolids {
  /// Convex; its corners are the contacts and some that touch nothing.
  Polyhedron moving;
  /// A box, shell 0, with a convex cavity, shell 1. The walls that nothing touches belong to a box, too.
  Polyhedron fixed;
  /// What the solids touch with: the contacts given, in their order, slid along their lines of action.
  /// Without those that cannot be corners of a convex block: of several with one normal on one line of action
  /// all but the first, and those that lie between others with the same normal. Their rows are positive
  /// combinations of the others', so that they change no motion.
  ContactRelation relation;
};

/// Solids whose contacts, as FindContacts finds them, are exactly the relation in the answer, with the motion
/// DOFs of the relation given; both are verified (InvariantError). An empty relation is a block that hovers.
/// PreconditionError: a singular contact, one without planes, a zero normal.
RelationSolids RealizeRelation(const ContactRelation& relation);

}  // namespace tact::algebra

/// @file
/// Whether a transition between two contact relations is valid [thesis, 2.7.4].
/// Model   Donald: of two relations between which nothing else happens one includes every contact of the other. A primitive
///         is included where one of the other relation has its elements, or elements that hold or bound them: an edge on a
///         face is part of a face on a face, and what an edge on the face's rim comes from. (As sets of point contacts
///         one relation would be many: an edge that sticks out of the face touches it with other points.)
///         The thesis: every DOF-transition is one of the practical ones. Both are necessary for what a person does, neither
///         is sufficient.
/// Exact   elements and integers.
#pragma once

#include <string>
#include <vector>

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/dof_transition.h"

namespace tact::recognition {

using Primitives = std::vector<algebra::ContactPrimitive>;

/// Whether both have the same elements in contact, in any order.
bool SameElements(const Primitives& a, const Primitives& b);

struct TransitionValidity {
  bool included = false;   // Donald
  bool practical = false;  // the thesis
  bool valid() const { return included && practical; }
};

struct RelationToCheck {
  const Primitives& primitives;
  const algebra::MotionDof& dof;
};

/// The same relation twice is valid.
TransitionValidity ValidityOf(const RelationToCheck& from, const RelationToCheck& to,
                              const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed);

/// "", "neither relation includes the other", "no practical DOF-transition", or both.
std::string ToString(const TransitionValidity& validity);

}  // namespace tact::recognition

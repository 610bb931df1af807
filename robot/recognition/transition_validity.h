/// @file
/// Whether a transition between two contact relations is valid [thesis, 2.7.4].
/// Model   Donald: of two relations between which nothing else happens one includes every point contact of the other.
///         The thesis: every DOF-transition is one of the practical ones. Both are necessary for what a person does, neither
///         is sufficient.
/// Exact   sets of elements and integers.
#pragma once

#include <vector>

#include "algebra/contact/dof_transition.h"
#include "robot/recognition/point_contact.h"

namespace tact::recognition {

/// A contact relation as its point contacts (sorted, each once), and their motion DOFs.
struct RelationSeen {
  std::vector<PointContact> contacts;
  algebra::MotionDof dof;
  friend bool operator==(const RelationSeen&, const RelationSeen&) = default;
};

struct TransitionValidity {
  bool included = false;   // Donald
  bool practical = false;  // the thesis
  bool valid() const { return included && practical; }
};

/// Of a transition between two different relations; the same relation twice is valid.
TransitionValidity ValidityOf(const RelationSeen& from, const RelationSeen& to);

/// "", "neither relation includes the other", "no practical DOF-transition", or both.
std::string ToString(const TransitionValidity& validity);

}  // namespace tact::recognition

/// @file
/// Contact formations that a tilt about a contact opens: neighbours by rotation.
/// Model   From a formation (contact_formation.h) at its pose the moving solid turns about a line through a contacting point,
///         parallel to a coordinate axis, by an angle whose half has one of a few tangents. Turning back leads into the
///         formation; along that path the same pairs of elements touch until its end, without overlap, which FollowPath
///         proves. Tilts that lead from one formation to the same pairs of elements count once.
/// Bound   Axes and angles are a sample: what is listed is there, more may be.
#pragma once

#include "algebra/contact/motion_path.h"
#include "enumerators/contact_formation.h"

namespace tact::enumerators {

struct Turn {
  algebra::Vector3 center;
  int axis = 0;               // 0, 1, 2: x, y, z
  algebra::Rational tangent;  // of half the angle, signed
  friend bool operator==(const Turn&, const Turn&) = default;
};

/// From the formation's pose.
algebra::MotionPath PathOf(const Turn& turn);

/// The pose of a solid that was translated and then turned.
algebra::Pose TurnedPose(const algebra::Vector3& translation, const Turn& turn);

struct TurnedContact {
  size_t border = 0;  // formation that turning back leads into
  Turn turn;
  algebra::FoundContacts contacts;  // of the tilted solid
};

struct TurnedContacts {
  std::vector<TurnedContact> found;  // by border, then as tried
  size_t undecided = 0;              // tilts whose path has an irrational event
};

TurnedContacts FindTurnedContacts(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed,
                                  const FormationComplex& complex);

}  // namespace tact::enumerators

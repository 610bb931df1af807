/// @file
/// Contact relations reduced to contacting points, each with its separate planes [thesis, 2.1].
/// Model   The moving object's legal first-order motions are the intersection over the contacts of the union
///         over a contact's planes of { n . v(p) >= 0 }, v(p) the velocity of the contacting point
///         [thesis, eq. (2.1), (2.2)].
/// Frames  points and normals in one frame that the caller names.
/// Units   points in one length unit; a normal times a positive number is the same plane.
#pragma once

#include <string>
#include <vector>

#include "algebra/screw/vector3.h"

namespace tact::algebra {

/// One contacting point. The normals point to the legal side. One plane: non-singular; several: any one of
/// them suffices (a union), the contact is singular.
struct Contact {
  Vector3 point;
  std::vector<Vector3> planes;
  std::string name;

  bool singular() const { return planes.size() > 1; }
  friend bool operator==(const Contact& a, const Contact& b) = default;
};

struct ContactRelation {
  std::vector<Contact> contacts;

  /// Whether some contact is singular.
  bool singular() const;
  /// The relation without its singular contacts [thesis, eq. (2.8)].
  ContactRelation WithoutSingular() const;
  friend bool operator==(const ContactRelation& a, const ContactRelation& b) = default;
};

}  // namespace tact::algebra

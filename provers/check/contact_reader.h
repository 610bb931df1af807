/// @file
/// Contacts as certificates write them, and their rows.
/// Model   The row of a plane n at the point (X/W, Y/W, Z/W) is [ (X,Y,Z) x n | W n ], as written.
#pragma once

#include "provers/check/exact_rank.h"
#include "provers/check/json_value.h"

namespace tact::check {

struct ContactNumbers {
  Row point;
  Matrix planes;  // normals
  Matrix rows;    // one a plane

  /// The same numbers as written.
  friend bool operator<(const ContactNumbers& a, const ContactNumbers& b) {
    return a.point != b.point ? a.point < b.point : a.planes < b.planes;
  }
};

/// Refused: W not positive, no plane, a zero normal, an unknown key.
ContactNumbers ReadContact(const Value& contact);

/// The right halves: of rows, the forces.
Matrix RightHalf(const Matrix& matrix);

}  // namespace tact::check

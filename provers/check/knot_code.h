/// @file
/// The code of a rope's diagram, read from a certificate and judged on its own: {"sigma":[...],"attr":[...]}.
/// Model   Columns from 1; sigma pairs them; attr is 1 over/-, 2 under/-, 3 over/+, 4 under/+. Faces are classes of the
///         four corners at each intersection, joined along the two sides of each segment and round the two ends.
/// Errors  Refused.
#pragma once

#include <vector>

#include "provers/check/json_value.h"

namespace tact::check {

struct KnotCode {
  std::vector<int> sigma, attr;  // of column i at [i - 1]

  int columns() const { return static_cast<int>(sigma.size()); }
  int mate(int column) const { return sigma[static_cast<std::size_t>(column) - 1]; }
  int attribute(int column) const { return attr[static_cast<std::size_t>(column) - 1]; }
  bool over(int column) const { return attribute(column) % 2 == 1; }
  bool plus(int column) const { return attribute(column) > 2; }
  /// Whether the other strand passes from right to left.
  bool turns_left(int column) const { return over(column) == plus(column); }

  friend bool operator==(const KnotCode&, const KnotCode&) = default;
};

/// Refuses what is no P-data.
KnotCode ReadKnotCode(const Value& value);
/// The same; refuses as well what no sphere holds.
KnotCode ReadCodeOnSphere(const Value& value);
/// The corners of each face: corner 4 (i - 1) + q of column i, q = 0 ahead on the left, 1 ahead on the right, 2 behind on the
/// left, 3 behind on the right. Returns the face of each corner, faces from 0 in the order of their first corners.
std::vector<int> FacesOfCorners(const KnotCode& code);
int CountFaces(const KnotCode& code);
/// Whether a sphere holds the diagram.
bool OnSphere(const KnotCode& code);

}  // namespace tact::check

/// @file
/// Planar diagram codes: the four arcs round each intersection [Mastin 2015], of open ropes as in [Dorier et al. 2018].
/// Model   Arcs are numbered along the rope. An intersection is X[i,j,k,l]: the arc on which the lower strand comes in,
///         then the others counterclockwise. The upper strand goes from j to l at a negative intersection, from l to j at
///         a positive one. An open rope has arcs 0..n, 0 and n once; segment s is arc s - 1. A closed knot has arcs 1..n,
///         each twice; arc 1 holds the point that P-data start from.
/// Loses   of an open rope: nothing. Of a closed knot: with one intersection its orientation.
/// Text    "PD[X[0,3,1,4],X[4,1,5,2],X[2,5,3,6]]"; no intersection: "PD[]".
/// Errors  PreconditionError: a code that FindPdFault refuses.
/// Cost    O(n).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

struct PdCode {
  std::vector<std::array<int, 4>> crossings;

  friend bool operator==(const PdCode&, const PdCode&) = default;
};

/// Why a code is none of an open rope.
struct PdFault {
  int crossing = 0;  // the first one that is wrong, from 1; 0: the code as a whole
  std::string what;  // "expected ..., got ..."
};

/// Arcs out of 0..n, strands that do not go on with the next arc, an arc that comes in twice.
std::optional<PdFault> FindPdFault(const PdCode& code);

/// Intersections as they are first met.
PdCode PdCodeOf(const PData& p);
/// Of the closed knot whose start and end meet on the first segment. Precondition: both ends of p lie on one face.
PdCode ClosedPdCodeOf(const PData& p);
/// Of an open rope's code; ClosedPdCodeOf has no inverse here.
PData PDataOf(const PdCode& code);

std::string ToText(const PdCode& code);

}  // namespace tact::knot

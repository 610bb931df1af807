/// @file
/// Signed Gauss codes of a rope or of a closed knot.
/// Model   The passes through intersections in the order of the rope, an intersection's number positive where the strand
///         that is followed is the upper one, negative where it is the lower; and the sign of each intersection. Numbers
///         1..c, each once over and once under, in any order; GaussCodeOf numbers them as they are first met.
/// Loses   nothing: P-data and signed Gauss codes numbered so are the same thing. A code without signs loses the mirror
///         image of each irreducible part; a closed knot's code loses which point it starts from.
/// Text    "O1+ U2+ U1+ O2+": O over, U under, the number, the sign. Extended [Dorier et al. 2018]: the numbers, then
///         the signs of intersections 1..c in one word, "1 -2 -1 2 ++"; where its region outside is, P-data do not say.
///         No intersection: "/".
/// Errors  PreconditionError: a code that FindGaussFault refuses.
/// Cost    O(n).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

struct GaussCode {
  std::vector<int> passes;  // +number over, -number under
  std::vector<int> signs;   // +1 or -1, of intersections 1..c

  friend bool operator==(const GaussCode&, const GaussCode&) = default;
};

/// Why a code is none.
struct GaussFault {
  int pass = 0;      // the first one that is wrong, from 1; 0: the code as a whole
  std::string what;  // "expected ..., got ..."
};

/// Passes that are not two for each sign, a number out of 1..c, an intersection passed twice at one height, a sign that is
/// neither +1 nor -1.
std::optional<GaussFault> FindGaussFault(const GaussCode& code);

GaussCode GaussCodeOf(const PData& p);
PData PDataOf(const GaussCode& code);

/// "O1+ U2+ U1+ O2+"
std::string ToText(const GaussCode& code);
/// "1 -2 -1 2 ++"
std::string ToExtendedText(const GaussCode& code);

}  // namespace tact::knot

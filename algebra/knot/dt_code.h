/// @file
/// Dowker-Thistlethwaite code of a closed knot [Dowker and Thistlethwaite 1983].
/// Model   The 2c passes are numbered from 1 along the knot; each intersection has an odd and an even number. The code is
///         the even numbers that belong to 1, 3, ..., 2c-1, negative where the even pass is the upper one.
/// Loses   where the rope's ends were; of each irreducible part, which of two mirror images it is.
/// Errors  PreconditionError: an intersection of two odd or two even numbers, as of no curve on a sphere.
/// Cost    O(n).
#pragma once

#include <string>
#include <vector>

#include "algebra/knot/closure.h"

namespace tact::knot {

std::vector<int> DtCodeOf(const ClosedCode& closed);

/// "4 6 2"; "/" of no intersection.
std::string DtText(const std::vector<int>& code);

}  // namespace tact::knot

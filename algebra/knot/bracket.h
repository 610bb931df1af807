/// @file
/// Normalized bracket polynomial of a rope with two ends: what Reidemeister moves keep.
/// Model   Smooth each intersection in both ways: along the rope's direction with a factor A^s, across it with A^-s, s its
///         sign; a state's strand is one arc from end to end and some loops, each a factor -A^2 - A^-2. The sum over all states
///         times (-A^3)^-w, w the sum of signs, is kept by R1, R2 and R3 [Turaev 2012, section 8.1; Kauffman 1987]. 1 for the
///         straight rope; a rope of which it is not 1 is tied by no Reidemeister moves alone. The converse is not known.
/// Cost    O(2^c c) for c intersections.
#pragma once

#include <cstdint>
#include <map>

#include "algebra/knot/p_data.h"

namespace tact::knot {

/// Coefficients by exponent of A, none 0.
using BracketPolynomial = std::map<int, int64_t>;

inline BracketPolynomial OneBracket() { return {{0, 1}}; }

/// PreconditionError: more than 24 intersections.
BracketPolynomial NormalizedBracket(const PData& p);

}  // namespace tact::knot

/// @file
/// The turns that a pairing of columns leaves open: one for each part of the rope, and no more.
/// Law     Let i < a < sigma(i) < sigma(a), so that the two intersections interlace. On a sphere turn(i) = turn(a) just
///         if an odd number of intersections have columns in two of the three gaps i..a, a..sigma(i),
///         sigma(i)..sigma(a).
/// Proof   The rope from i to sigma(i) and from a to sigma(a) are two closed curves with a..sigma(i) in common. Pushed
///         apart there, they cross once more if turn(i) = turn(a), and where one column of an intersection is on one
///         curve and the other on the other: once for two gaps, twice or not at all for one. On a sphere two closed
///         curves cross an even number of times.
/// So      one turn decides all turns of an interlacement class (reducible.h); mirroring one part alone keeps the
///         diagram on its sphere. A planar pairing of k parts has 2^k choices of turns, an irreducible one two that are
///         mirror images [thesis, Proposition 9]. For closed curves see [Fraysseix and Ossona de Mendez 1999].
/// Cost    O(n) for a pair, O(n^3) for all turns.
#pragma once

#include <optional>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

/// Whether the law asks for equal turns. Precondition: i < a < sigma(i) < sigma(a). p's attributes play no part.
bool TurnsAgree(const PData& p, int i, int a);

/// A diagram on a sphere with p's pairing and heights: turn +1 at the first column of each part, the others by the law.
/// None: no turns will do. p's own signs play no part.
std::optional<PData> WithPlanarTurns(const PData& p);

}  // namespace tact::knot

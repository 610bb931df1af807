/// @file
/// Codes of a sphere counted without visiting them: a transfer method that follows the rope and remembers only what is unexplored.
/// Model   The rope is followed from its selective end. What it has met divides the sphere into holes; round each hole, strands of
///         the diagram dangle into it, one of them the rope's tip, the others in pairs: what comes in at one is known to go on at
///         the other. The tip next
///           - meets a strand that nothing is known of: a new intersection, whose two other strands dangle beside the tip, or
///           - is the same strand as one that dangles into its hole: the hole falls in two, and the tip goes on at that one's
///             partner, or
///           - ends, if nothing else dangles.
///         How many codes complete a state depends on the cyclic order and the pairs alone, so states are kept once, with the
///         number of ways that lead there, numbered by a walk from the tip and, of the two mirror images, the lesser. A hole that no
///         pair connects with the tip, and a second hole with an odd number of strands, cannot be completed.
/// Cost    some 2.8^n states, 10^6 a layer at n = 16; the codes are about 10^n.
/// Errors  InvariantError: a count does not fit 64 bits (n = 20).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace tact::enumerators {

struct TransferProgress {
  int layer, layers;
  size_t states;
};

/// How many codes there are with 0, 1, ..., `crossings` intersections.
std::vector<uint64_t> CountCodesByTransfer(int crossings,
                                           const std::function<void(const TransferProgress&)>& progress = {});

}  // namespace tact::enumerators

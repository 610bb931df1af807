/// @file
/// Every R_III of a world, and which statements about it fail, counted.
#pragma once

#include <array>
#include <map>
#include <utility>

#include "provers/claims/knot_world.h"

namespace tact::provers {

using Triangle = std::array<int, 3>;  // segments A, B, C

/// The segment, of the three, that column c's intersection lies on besides its own; 0 if it is none of them.
int Partner(const knot::PData& p, const Triangle& s, int c);

struct TriangleTally {
  long long moves = 0, proposition10 = 0, corollary1 = 0, proposition11 = 0, proposition12 = 0,
            corollary2 = 0, proposition13 = 0, neighbours = 0, two_apart = 0;
  long long triangles = 0, at_an_end = 0, twice = 0, no_top = 0;
  std::map<char, long long> types;
  std::map<std::pair<char, char>, long long> transitions;
};

/// Of all P-data to the bound and of random ropes.
const TriangleTally& TallyTo(Effort effort);

}  // namespace tact::provers

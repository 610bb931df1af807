/// @file
/// Families of pairs of solids whose contact formations are counted: blocks, prisms in slots, pegs and holes, undercuts, and
/// convex solids with up to eight vertices.
/// Model   All corners are integer. Slots and holes are given to parts as wide as themselves, slimmer ones and wider ones.
///         The convex solids are the hulls of the sets of a cube's corners, one for each way they can lie in the cube up
///         to its symmetries, against solids with axis-parallel faces.
#pragma once

#include <string>
#include <vector>

#include "algebra/solid/polyhedron.h"

namespace tact::enumerators {

struct SolidPair {
  std::string family;  // "prisms in slots"
  std::string name;    // "T in a slot of width 1"
  algebra::Polyhedron moving, fixed;
  bool turns = false;  // whether tilts are to be tried too: they cost ten times as much
};

/// Some seconds, a minute, some minutes on one core. Each holds the pairs of the smaller ones, in the same order.
enum class FamilySize { kSmall, kMedium, kLarge };

/// A family's pairs stand together.
std::vector<SolidPair> SolidPairs(FamilySize size);

/// The hulls, with vertices of {0, 1}^3, by increasing number of vertices.
std::vector<algebra::Polyhedron> CornerHulls();

}  // namespace tact::enumerators

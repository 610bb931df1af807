/// @file
/// Solids with integer corners and axis-parallel faces: unions of unit cubes, each built as one closed surface.
/// Errors  algebra::SoupError: cubes that meet in an edge or a corner only, so that the surface is no manifold.
#pragma once

#include <array>
#include <vector>

#include "algebra/solid/polyhedron.h"

namespace tact::enumerators {

/// All unit cubes from one corner to the other.
struct LatticeBox {
  std::array<int, 3> from, to;
};

/// The cubes of the filled boxes less those of the carved ones. PreconditionError: nothing is left.
algebra::Polyhedron LatticeSolid(const std::vector<LatticeBox>& filled,
                                 const std::vector<LatticeBox>& carved = {});

}  // namespace tact::enumerators

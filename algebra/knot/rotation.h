/// @file
/// Rotation systems of the knot graph: in which order the edges leave each intersection, whatever the rope does there.
/// Model   Of edge e_k of thesis_graphs.h, +k leaves column k's intersection and -k that of column k + 1. A rotation
///         lists for each vertex what leaves it, counterclockwise, from the least. Tracing it gives the faces of the
///         surface that the graph fills: with v vertices and e edges, v - e + f = 2 on a sphere. A knot graph hangs
///         together, so its rotations are all the ways to draw it on closed surfaces.
/// Cost    O(n) a rotation; a vertex of four edges has six.
#pragma once

#include <functional>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

using Rotation = std::vector<std::vector<int>>;

/// The rotation of p's own diagram.
Rotation RotationOf(const PData& p);
/// Seen from the other side: every order reversed.
Rotation MirrorRotation(const Rotation& rotation);

/// The faces' darts, each from its least.
std::vector<std::vector<int>> TraceFaces(const Rotation& rotation);
/// Of the surface that tracing builds.
int Genus(const Rotation& rotation);

/// Whether no strand turns: where four edges leave an intersection, those of one strand are opposite. Where the rope
/// ends, the missing edge can always be put opposite.
bool IsStraight(const Rotation& rotation);

/// Visits every planar rotation of p's knot graph once, in an order that does not vary. Attributes play no part.
void ForEachPlanarRotation(const PData& p, const std::function<void(const Rotation&)>& visit);

/// The same for two rotations just if a homeomorphism of their surfaces, orientation kept or not, carries one drawing
/// without names to the other.
std::vector<int> NamelessCode(const Rotation& rotation);

}  // namespace tact::knot

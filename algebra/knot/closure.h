/// @file
/// A rope's two ends joined by an arc over or under everything: a closed knot.
/// Model   The arc leaves the other end and comes back to the selective end along a shortest path through the faces,
///         crossing each segment on its way over (overpass) or under (underpass). The knot's type depends on over or under
///         only, not on the path [Turaev 2012]. If both ends lie on one face nothing is crossed.
/// Loses   where the rope's ends were. Both types of knot stay under Reidemeister moves of the rope, not under Cross moves;
///         ropes that no such moves join may have the same.
/// Pre     P-data are planar (faces.h).
/// Cost    O(n).
#pragma once

#include <vector>

#include "algebra/knot/faces.h"
#include "algebra/knot/gauss_code.h"

namespace tact::knot {

enum class Pass { kOver, kUnder };

/// The segments that the arc crosses as darts: it passes each from left to right. Empty: both ends lie on one face. Of
/// the shortest paths the one that a breadth-first search round the faces' walks finds first.
std::vector<Dart> ClosingPath(const PData& p);

/// p with the arc as its last columns: both ends lie on one face.
PData CloseBy(const PData& p, Pass pass);

/// A closed knot's diagram.
struct ClosedCode {
  /// The knot cut open where its ends were joined: both ends lie on one face.
  PData cut;

  /// Passes and signs, from the cut on: as Regina's Link::fromData(signs..., passes) takes them.
  GaussCode Gauss() const { return GaussCodeOf(cut); }
  /// As Regina's Link::fromOrientedGauss takes it, "+<1 -<2 ...": + over, - under; < if the other strand passes from right
  /// to left, > if from left to right.
  std::string OrientedGauss() const;
};
ClosedCode Close(const PData& p, Pass pass);

/// The same of a rope whose ends lie on one face already: joined without an arc. PreconditionError: they do not.
ClosedCode JoinEnds(const PData& p);

/// Whether both ends lie on one face: a long knot.
bool EndsOnOneFace(const PData& p);

}  // namespace tact::knot

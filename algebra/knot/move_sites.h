/// @file
/// Where moves happen, as darts and columns; shared by the files that apply, generate and detect moves.
#pragma once

#include "algebra/knot/columns.h"
#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"

namespace tact::knot {

/// Columns of the larger P-data that an R1, R2 or Cross adds, in ascending order with mates and attributes; n columns in
/// the smaller.
struct AddedColumns {
  Renumbering to;
  std::array<NewColumn, 4> columns{};
  int count = 0;
};
AddedColumns ColumnsOf(const Move& move, int n);
/// Where the other columns go: the same as ColumnsOf(move, n).to for every n.
Renumbering PlacesOf(const Move& move);

/// The darts with the face on their left in which an R2 takes place, of the segments i and j.
struct R2Site {
  Dart i, j;
};
/// Strand i leaves the face over segment j: turn of its first new column is +1 just if the face is on j's left.
inline R2Site SiteOfR2(const Move& move) {
  const bool over = (move.attr & 1) == 1, plus = move.attr > 2;
  const bool j_left = over == plus;
  return {{move.segments[0], move.opposite ? j_left : !j_left}, {move.segments[1], j_left}};
}

/// The dart of the end's face that a Cross passes from left to right.
inline Dart SiteOfCross(const Move& move) {
  const bool over = (move.attr & 1) == 1, plus = move.attr > 2;
  const bool turns_left = over == plus;  // along the rope; the selective end moves against it
  return {move.segments[0], move.end == RopeEnd::kSelective ? !turns_left : turns_left};
}
/// A dart of the face that the end lies in.
inline Dart DartAtEnd(const PData& p, RopeEnd end) {
  return end == RopeEnd::kSelective ? Dart{1, false} : Dart{p.segments(), true};
}

/// Whether both darts have the same face on their left.
bool SameFace(const PData& p, Dart a, Dart b);

/// The R2 that takes columns i, i+1 and their mates away, i the first of the four; nullopt if they bound no lens: mates
/// side by side, both strands at the same height, signs that differ [thesis, eq. (5.5)-(5.7)].
std::optional<Move> R2RemovalAt(const PData& p, int i);

/// The R3 at the triangle that starts with this dart; nullopt if its face is none, meets an intersection twice, or has no
/// strand over both others.
std::optional<Move> R3At(const PData& p, Dart first);

}  // namespace tact::knot

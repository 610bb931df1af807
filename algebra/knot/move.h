/// @file
/// Movement primitives: Reidemeister moves I, II, III and the Cross move [thesis, 5.2], as values that are applied, undone,
/// generated from the faces and detected between two P-data.
/// Model   A move adds or removes intersections, or shifts a strand across one (III). Its segments are counted in the P-data
///         with fewer intersections, as in the thesis:
///           R1     segment i gets columns i, i+1
///           R2     segments i <= j get columns i, i+1 and j+2, j+3; i = j: two places of one segment, which the thesis'
///                  range leaves out [thesis, eq. (5.5)-(5.7)]
///           R3     segments i, j, k: the one over both others, the middle one, the one under both; they bound a face
///           Cross  the selective end crosses segment i: columns 1, i+1; the other end segment j: columns j, n
///         attr is the attribute of the first new column (R1, R2) or of the end's column (Cross); with `opposite` (R2: the
///         strands meet the two intersections in opposite order, eq. (5.6)) it says all of the rest.
/// Pre     P-data are planar (faces.h): a move is one of curves on a sphere.
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

enum class MoveKind { kR1, kR2, kR3, kCross };
enum class MoveDirection { kAdd, kRemove, kShift };
enum class RopeEnd { kNone, kSelective, kOther };

struct Move {
  MoveKind kind = MoveKind::kR1;
  MoveDirection direction = MoveDirection::kAdd;
  std::array<int, 3> segments{};  // those not used: 0
  RopeEnd end = RopeEnd::kNone;   // of Cross
  int attr = 0;                   // 0 for R3
  bool opposite = false;          // of R2

  friend bool operator==(const Move&, const Move&) = default;
  /// The canonical order of moves.
  friend auto operator<=>(const Move&, const Move&) = default;
};

/// Why p does not admit the move: "expected ..., got ..."; nullopt if it does. O(n).
std::optional<std::string> FindMoveFault(const PData& p, const Move& move);
/// What the move makes of p. PreconditionError: FindMoveFault finds one.
PData Apply(const PData& p, const Move& move);
/// The move that leads back. An R3 is its own inverse.
Move Inverse(const Move& move);
/// The move of the equivalent P-data that does the same to the rope; smaller is the P-data with fewer intersections.
Move EquivalentMove(const PData& smaller, const Move& move);

/// Every move that p admits, in canonical order. A P-data that two moves lead to comes twice.
/// At most so many intersections after it.
std::vector<Move> AllMoves(const PData& p, int most_crossings = 1 << 28);

/// Every single move that turns a into b, both read off from the same end, in canonical order: sound and complete
/// (thesis_rules.h has the thesis' rules, which are neither). Allocates for the answer, and once where
/// there are many places for an R2.
/// Cost    O(n), however many moves or places for one there are.
std::vector<Move> DetectMoves(const PData& a, const PData& b);

/// A move that explains a transition, the selective end of b being the same as a's or the other one.
struct Explanation {
  Move move;  // turns a into b, or into b's equivalent P-data if swapped
  bool swapped = false;

  friend bool operator==(const Explanation&, const Explanation&) = default;
};
/// All of them: those with the same end first. If b is its own equivalent both are listed.
std::vector<Explanation> ExplainTransition(const PData& a, const PData& b);

}  // namespace tact::knot

#include "algebra/knot/move.h"

#include "algebra/error.h"
#include "algebra/knot/move_sites.h"

namespace tact::knot {
namespace {

std::string Text(int number) { return std::to_string(number); }

// What is wrong with the move's parameters alone; n columns in the smaller P-data.
std::optional<std::string> FindShapeFault(const Move& move, int n) {
  const bool shift = move.kind == MoveKind::kR3;
  if (shift != (move.direction == MoveDirection::kShift)) {
    return shift ? "expected direction \"shift\" for an R3, got another"
                 : "expected direction \"add\" or \"remove\", got \"shift\"";
  }
  const size_t used = shift ? 3 : move.kind == MoveKind::kR2 ? 2 : 1;
  for (size_t i = 0; i < 3; ++i) {
    const int segment = move.segments[i];
    if (i >= used && segment != 0) return "expected " + std::to_string(used) + " segments, got more";
    if (i < used && (segment < 1 || segment > n + 1))
      return "expected a segment from 1 to " + Text(n + 1) + ", got " + Text(segment);
  }
  if (move.kind == MoveKind::kR2 && move.segments[0] > move.segments[1])
    return "expected the lesser segment first, got " + Text(move.segments[0]) + ", " + Text(move.segments[1]);
  if (shift ? move.attr != 0 : move.attr < 1 || move.attr > 4)
    return "expected " + std::string(shift ? "no attribute" : "an attribute from 1 to 4") + ", got " +
           Text(move.attr);
  if ((move.kind == MoveKind::kCross) != (move.end != RopeEnd::kNone))
    return move.end == RopeEnd::kNone ? "expected the end that crosses, got none"
                                      : "expected an end for a Cross move only, got one";
  if (move.opposite && move.kind != MoveKind::kR2) return "expected an order for an R2 only, got one";
  return std::nullopt;
}

std::optional<std::string> FindAdditionFault(const PData& p, const Move& move) {
  if (move.kind == MoveKind::kR2) {
    const R2Site site = SiteOfR2(move);
    if (!SameFace(p, site.i, site.j)) {
      return "expected segments " + Text(site.i.segment) + " and " + Text(site.j.segment) +
             " with those sides on one face, got two faces";
    }
  } else if (move.kind == MoveKind::kCross && !SameFace(p, DartAtEnd(p, move.end), SiteOfCross(move))) {
    return "expected segment " + Text(move.segments[0]) +
           " with that side on the end's face, got another face";
  }
  return std::nullopt;
}

std::optional<std::string> FindRemovalFault(const PData& p, const Move& move) {
  const AddedColumns added = ColumnsOf(move, p.columns() - (move.kind == MoveKind::kR2 ? 4 : 2));
  for (int k = 0; k < added.count; ++k) {
    const NewColumn& c = added.columns[static_cast<size_t>(k)];
    if (p.sigma(c.column) == c.sigma && p.attr(c.column) == c.attr) continue;
    return "expected column " + Text(c.column) + " with mate " + Text(c.sigma) + " and attribute " +
           Text(c.attr) + ", got " + Text(p.sigma(c.column)) + " and " + Text(p.attr(c.column));
  }
  return std::nullopt;
}

PData Shift(const PData& p, const Move& move) {
  const auto swapped = [&](int column) {
    for (const int s : move.segments) {
      if (column == s - 1) return s;
      if (column == s) return s - 1;
    }
    return column;
  };
  PDataBuilder shifted(p.columns());
  for (int i = 1; i <= p.columns(); ++i) shifted.Add(swapped(p.sigma(swapped(i))), p.attr(swapped(i)));
  return shifted.Take();
}

}  // namespace

std::optional<std::string> FindMoveFault(const PData& p, const Move& move) {
  const int taken = move.direction == MoveDirection::kRemove ? (move.kind == MoveKind::kR2 ? 4 : 2) : 0;
  if (p.columns() < taken) {
    return "expected " + Text(taken / 2) + (taken == 2 ? " intersection" : " intersections") +
           " to remove, got " + Text(p.crossings());
  }
  if (auto fault = FindShapeFault(move, p.columns() - taken)) return fault;
  if (move.direction == MoveDirection::kAdd) return FindAdditionFault(p, move);
  if (move.direction == MoveDirection::kRemove) return FindRemovalFault(p, move);
  for (const bool forward : {false, true}) {
    if (R3At(p, {move.segments[0], forward}) == move) return std::nullopt;
  }
  return "expected segments " + Text(move.segments[0]) + ", " + Text(move.segments[1]) + ", " +
         Text(move.segments[2]) +
         " round a face, the first over both others and the last under both, got others";
}

PData Apply(const PData& p, const Move& move) {
  if (const auto fault = FindMoveFault(p, move)) throw PreconditionError("Apply: " + *fault);
  if (move.direction == MoveDirection::kShift) return Shift(p, move);
  const int taken = move.direction == MoveDirection::kRemove ? (move.kind == MoveKind::kR2 ? 4 : 2) : 0;
  const AddedColumns added = ColumnsOf(move, p.columns() - taken);
  const auto& c = added.columns;
  if (move.direction == MoveDirection::kAdd) {
    return added.count == 2 ? InsertColumns(p, added.to, {c[0], c[1]})
                            : InsertColumns(p, added.to, {c[0], c[1], c[2], c[3]});
  }
  return added.count == 2 ? RemoveColumns(p, {c[0].column, c[1].column})
                          : RemoveColumns(p, {c[0].column, c[1].column, c[2].column, c[3].column});
}

Move Inverse(const Move& move) {
  Move inverse = move;
  if (move.direction == MoveDirection::kAdd) inverse.direction = MoveDirection::kRemove;
  if (move.direction == MoveDirection::kRemove) inverse.direction = MoveDirection::kAdd;
  return inverse;
}

Move EquivalentMove(const PData& smaller, const Move& move) {
  Move other = move;
  const int segments = smaller.segments();
  for (int& s : other.segments) s = s == 0 ? 0 : segments + 1 - s;
  const int opposite_sign = move.attr > 2 ? move.attr - 2 : move.attr + 2;
  if (move.kind == MoveKind::kR1) other.attr = MateAttribute(move.attr);
  if (move.kind == MoveKind::kR2) {
    // Read backward, the strand of the last new column comes first.
    std::swap(other.segments[0], other.segments[1]);
    other.attr = MateAttribute(move.opposite ? move.attr : opposite_sign);
  }
  if (move.kind == MoveKind::kCross)
    other.end = move.end == RopeEnd::kSelective ? RopeEnd::kOther : RopeEnd::kSelective;
  return other;
}

}  // namespace tact::knot

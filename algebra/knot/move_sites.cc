#include "algebra/knot/move_sites.h"

#include <algorithm>

namespace tact::knot {

Renumbering PlacesOf(const Move& move) {
  const int i = move.segments[0];
  switch (move.kind) {
    case MoveKind::kR1:
      return {i, 2};
    case MoveKind::kR2:
      return {i, 2, move.segments[1], 2};
    case MoveKind::kCross:
      return move.end == RopeEnd::kSelective ? Renumbering{1, 1, i, 1} : Renumbering{i, 1};
    case MoveKind::kR3:
      break;
  }
  return {};
}

AddedColumns ColumnsOf(const Move& move, int n) {
  const int i = move.segments[0], j = move.segments[1], attr = move.attr, mate = MateAttribute(attr);
  AddedColumns added;
  added.to = PlacesOf(move);
  switch (move.kind) {
    case MoveKind::kR1:
      added.columns = {NewColumn{i, i + 1, attr}, {i + 1, i, mate}};
      added.count = 2;
      break;
    case MoveKind::kR2: {
      // The same height with the other sign.
      const int attr2 = attr > 2 ? attr - 2 : attr + 2, mate2 = MateAttribute(attr2);
      const int first = move.opposite ? j + 3 : j + 2, second = move.opposite ? j + 2 : j + 3;
      added.columns = {NewColumn{i, first, attr},
                       {i + 1, second, attr2},
                       {j + 2, move.opposite ? i + 1 : i, move.opposite ? mate2 : mate},
                       {j + 3, move.opposite ? i : i + 1, move.opposite ? mate : mate2}};
      added.count = 4;
      break;
    }
    case MoveKind::kCross:
      if (move.end == RopeEnd::kSelective) {
        added.columns = {NewColumn{1, i + 1, attr}, {i + 1, 1, mate}};
      } else {
        added.columns = {NewColumn{i, n + 2, mate}, {n + 2, i, attr}};
      }
      added.count = 2;
      break;
    case MoveKind::kR3:
      break;
  }
  return added;
}

bool SameFace(const PData& p, Dart a, Dart b) {
  Dart d = a;
  do {
    if (d == b) return true;
    d = NextDart(p, d);
  } while (d != a);
  return false;
}

std::optional<Move> R2RemovalAt(const PData& p, int i) {
  const int first = p.sigma(i), second = p.sigma(i + 1), least = std::min(first, second);
  if (least <= i + 1 || std::max(first, second) != least + 1) return std::nullopt;
  if (p.over(i) != p.over(i + 1) || p.sign(i) == p.sign(i + 1)) return std::nullopt;
  return Move{MoveKind::kR2, MoveDirection::kRemove, {i, least - 2, 0}, {}, p.attr(i), first > second};
}

std::optional<Move> R3At(const PData& p, Dart first) {
  const std::array<Dart, 3> darts = {first, NextDart(p, first), NextDart(p, NextDart(p, first))};
  if (NextDart(p, darts[2]) != first) return std::nullopt;
  Move move{MoveKind::kR3, MoveDirection::kShift, {0, 0, 0}};
  std::array<int, 3> met{};
  for (size_t side = 0; side < 3; ++side) {
    const int segment = darts[side].segment;
    if (segment == 1 || segment == p.segments()) return std::nullopt;
    const bool over1 = p.over(segment - 1), over2 = p.over(segment);
    int& place = move.segments[over1 && over2 ? 0 : over1 || over2 ? 1 : 2];
    if (place != 0) return std::nullopt;
    place = segment;
    const int column = darts[side].forward ? segment : segment - 1;
    met[side] = std::min(column, p.sigma(column));
  }
  if (met[0] == met[1] || met[1] == met[2] || met[2] == met[0]) return std::nullopt;
  return move;
}

}  // namespace tact::knot

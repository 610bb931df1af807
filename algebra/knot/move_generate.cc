// Every move that a P-data admits, read off from its faces.
#include <algorithm>

#include "algebra/knot/move_sites.h"

namespace tact::knot {
namespace {

// The attribute that makes an R2 or a Cross take place at a site; the inverses of SiteOfR2 and SiteOfCross.
int AttributeAtR2(Dart j, bool over) { return AttributeOf(over, j.forward ? 1 : -1); }
int AttributeAtCross(Dart d, RopeEnd end, bool over) {
  return AttributeOf(over, d.forward == (end == RopeEnd::kOther) ? 1 : -1);
}

void AddR1(const PData& p, std::vector<Move>& moves) {
  for (int i = 1; i <= p.segments(); ++i) {
    for (int attr = 1; attr <= 4; ++attr)
      moves.push_back({MoveKind::kR1, MoveDirection::kAdd, {i, 0, 0}, {}, attr});
  }
}

void AddR2(const Faces& faces, std::vector<Move>& moves) {
  for (int f = 0; f < faces.count(); ++f) {
    const auto& walk = faces.walk(f);
    for (size_t a = 0; a < walk.size(); ++a) {
      for (size_t b = a; b < walk.size(); ++b) {
        const bool opposite = walk[a].forward == walk[b].forward;
        for (const bool over : {true, false}) {
          const auto add = [&](Dart i, Dart j) {
            moves.push_back({MoveKind::kR2,
                             MoveDirection::kAdd,
                             {i.segment, j.segment, 0},
                             {},
                             AttributeAtR2(j, over),
                             opposite});
          };
          if (walk[a].segment <= walk[b].segment) add(walk[a], walk[b]);
          if (walk[a].segment > walk[b].segment || (walk[a].segment == walk[b].segment && a != b))
            add(walk[b], walk[a]);
        }
      }
    }
  }
}

void AddCross(const PData& p, const Faces& faces, std::vector<Move>& moves) {
  for (const RopeEnd end : {RopeEnd::kSelective, RopeEnd::kOther}) {
    for (const Dart d : faces.walk(faces.left_of(DartAtEnd(p, end)))) {
      for (const bool over : {true, false}) {
        moves.push_back(
            {MoveKind::kCross, MoveDirection::kAdd, {d.segment, 0, 0}, end, AttributeAtCross(d, end, over)});
      }
    }
  }
}

void RemoveR1AndCross(const PData& p, std::vector<Move>& moves) {
  const int n = p.columns();
  for (int i = 1; i < n; ++i) {
    if (p.sigma(i) == i + 1)
      moves.push_back({MoveKind::kR1, MoveDirection::kRemove, {i, 0, 0}, {}, p.attr(i)});
  }
  if (n == 0) return;
  moves.push_back(
      {MoveKind::kCross, MoveDirection::kRemove, {p.sigma(1) - 1, 0, 0}, RopeEnd::kSelective, p.attr(1)});
  moves.push_back({MoveKind::kCross, MoveDirection::kRemove, {p.sigma(n), 0, 0}, RopeEnd::kOther, p.attr(n)});
}

void RemoveR2(const PData& p, std::vector<Move>& moves) {
  for (int i = 1; i + 1 <= p.columns(); ++i) {
    if (const auto move = R2RemovalAt(p, i)) moves.push_back(*move);
  }
}

void AddR3(const PData& p, const Faces& faces, std::vector<Move>& moves) {
  for (int f = 0; f < faces.count(); ++f) {
    if (faces.walk(f).size() != 3) continue;
    if (const auto move = R3At(p, faces.walk(f)[0])) moves.push_back(*move);
  }
}

}  // namespace

std::vector<Move> AllMoves(const PData& p, int most_crossings) {
  const Faces faces(p);
  std::vector<Move> moves;
  if (p.crossings() + 1 <= most_crossings) {
    AddR1(p, moves);
    AddCross(p, faces, moves);
  }
  if (p.crossings() + 2 <= most_crossings) AddR2(faces, moves);
  RemoveR1AndCross(p, moves);
  RemoveR2(p, moves);
  AddR3(p, faces, moves);
  std::sort(moves.begin(), moves.end());
  return moves;
}

}  // namespace tact::knot

#include "provers/claims/knot_triangle_tally.h"

#include <set>

#include "algebra/knot/thesis_rules.h"

namespace tact::provers {

using knot::Move;
using knot::MoveKind;
using knot::PData;
using knot::thesis::PermittedType;
using knot::thesis::TypeOf;

int Partner(const PData& p, const Triangle& s, int c) {
  for (const int segment : s) {
    if (p.sigma(c) == segment - 1 || p.sigma(c) == segment) return segment;
  }
  return 0;
}

namespace {

// What of the statements fails for the move, counted.
void AddMove(TriangleTally& tally, const PData& p, const Move& move) {
  const PData q = Apply(p, move);
  const Triangle& s = move.segments;
  ++tally.moves;
  bool apart = true, distinct = true, exchanged = true, never_kept = true;
  for (size_t x = 0; x < 3; ++x) {
    const int i = s[x];
    for (const PData* at : {&p, &q}) {
      apart = apart && at->sigma(i) != i - 1;
      const int here = Partner(*at, s, i - 1), there = Partner(*at, s, i);
      distinct = distinct && here != 0 && there != 0 && here != there && here != i && there != i;
    }
    // Of a segment's two columns, each meets the partner after that the other one met before.
    exchanged =
        exchanged && Partner(p, s, i - 1) == Partner(q, s, i) && Partner(p, s, i) == Partner(q, s, i - 1);
    never_kept = never_kept && p.sigma(i - 1) != q.sigma(i);
    const int apart_by = std::abs(s[x] - s[(x + 1) % 3]);
    tally.neighbours += apart_by == 1 ? 1 : 0;
    tally.two_apart += apart_by == 2 ? 1 : 0;
  }
  tally.proposition10 += apart ? 0 : 1;
  tally.corollary1 += distinct ? 0 : 1;
  tally.proposition12 += exchanged ? 0 : 1;
  tally.corollary2 += never_kept ? 0 : 1;
  // The move back, found from q's faces alone, has the same segments, so they come in the same order.
  bool same = false;
  for (const Move& back : AllMoves(q, q.crossings()))
    same = same || (back.kind == MoveKind::kR3 && back.segments == s && Apply(q, back) == p);
  tally.proposition11 += same ? 0 : 1;
  const auto before = TypeOf(p, s), after = TypeOf(q, s);
  if (!before || !after || *after != PermittedType(*before)) ++tally.proposition13;
  if (!before || !after) return;
  ++tally.types[*before];
  ++tally.transitions[{*before, *after}];
}

// Why a face of three sides admits no R_III.
void AddTriangles(TriangleTally& tally, const PData& p) {
  const knot::Faces faces(p);
  for (int f = 0; f < faces.count(); ++f) {
    const auto& walk = faces.walk(f);
    if (walk.size() != 3) continue;
    ++tally.triangles;
    std::set<int> met;
    bool at_an_end = false;
    for (const knot::Dart d : walk) {
      at_an_end = at_an_end || d.segment == 1 || d.segment == p.segments();
      const int column = std::clamp(d.forward ? d.segment : d.segment - 1, 1, p.columns());
      met.insert(std::min(column, p.sigma(column)));
    }
    const auto over_both = [&](knot::Dart d) { return p.over(d.segment - 1) && p.over(d.segment); };
    if (at_an_end) {
      ++tally.at_an_end;
    } else if (met.size() < 3) {
      ++tally.twice;
    } else if (std::none_of(walk.begin(), walk.end(), over_both)) {
      ++tally.no_top;
    }
  }
}

TriangleTally Count(Effort effort) {
  TriangleTally tally;
  ForEachPlanarPDataTo(BoundsOf(effort).triangle, [&](const PData& p) {
    AddTriangles(tally, p);
    for (const Move& move : AllMoves(p, p.crossings())) {
      if (move.kind == MoveKind::kR3) AddMove(tally, p, move);
    }
  });
  ForEachRandomMove(effort, [&](const PData& p, const Move& move) {
    if (move.kind == MoveKind::kR3) AddMove(tally, p, move);
  });
  return tally;
}

}  // namespace

const TriangleTally& TallyTo(Effort effort) { return KeptFor<Count>(effort); }

}  // namespace tact::provers

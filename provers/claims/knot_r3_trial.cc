#include "provers/claims/knot_r3_trial.h"

#include <set>

namespace tact::provers {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using knot::thesis::AcceptsR3;
using knot::thesis::R3Reading;
using knot::thesis::R3Triangle;
using Segments = std::array<int, 3>;

const std::vector<R3Variant>& R3Variants() {
  static const std::vector<R3Variant> variants = {
      {"named by heights before", "named-before", {R3Triangle::kNamedBefore, false, false}},
      {"named by heights twice", "named-twice", {R3Triangle::kNamedTwice, false, false}},
      {"and the triangles are faces", "faces", {R3Triangle::kFaces, false, false}},
      {"and signs are kept", "faces-signs", {R3Triangle::kFaces, true, false}},
      {"the same, segment n too", "corrected", {R3Triangle::kFaces, true, true}},
      {"named twice, signs kept, segment n too", "signs-only", {R3Triangle::kNamedTwice, true, true}},
      {"faces, segment n too, signs not kept", "faces-whole-range", {R3Triangle::kFaces, false, true}}};
  return variants;
}

namespace {

void TryMove(R3Trial& trial, const PData& p, const Move& move, const R3Reading& reading) {
  ++trial.moves;
  const PData q = Apply(p, move);
  const auto& s = move.segments;
  if (AcceptsR3(p, q, s, reading)) return;
  ++trial.missed;
  trial.missed_inside += std::max({s[0], s[1], s[2]}) < p.columns() ? 1 : 0;
  trial.least_missed.Offer(p, q, move);
}

// p with the six columns of the segments as an R_III pairs them, with these attributes where A meets B, A C, and B C.
PData Repaired(const PData& p, const Segments& s, const std::array<int, 3>& attributes) {
  std::vector<int> sigma = p.SigmaRow(), attr = p.AttrRow();
  const auto other_end = [&](int column) {
    for (const int segment : s) {
      if (column == segment - 1) return segment;
      if (column == segment) return segment - 1;
    }
    return column;
  };
  const auto at = [](int column) { return static_cast<size_t>(column) - 1; };
  const auto meet = [&](size_t x, size_t y, int attribute) {
    // The column of x that is not shared with y before becomes the one that is.
    const int mate = p.sigma(s[x]);
    const bool at_end = mate == s[y] || mate == s[y] - 1;
    const int here = at_end ? s[x] - 1 : s[x];
    const int there = other_end(p.sigma(at_end ? s[x] : s[x] - 1));
    sigma[at(here)] = there;
    sigma[at(there)] = here;
    attr[at(here)] = attribute;
    attr[at(there)] = knot::MateAttribute(attribute);
  };
  meet(0, 1, attributes[0]);
  meet(0, 2, attributes[1]);
  meet(1, 2, attributes[2]);
  return PData(sigma, attr);
}

// Segments that may be A, B, C of p.
std::set<Segments> Triangles(const PData& p) {
  std::set<Segments> triangles;
  for (int i = 2; i <= p.columns(); ++i) {
    if (!p.over(i - 1) || !p.over(i)) continue;
    const int b = p.sigma(i - 1), c = p.sigma(i);
    for (const auto& [x, y] : {std::pair{b, c}, std::pair{c, b}}) {
      for (const int j : {x, x + 1}) {
        for (const int k : {y, y + 1}) {
          if (std::min(j, k) >= 2 && std::max(j, k) <= p.columns() && knot::thesis::TypeOf(p, {i, j, k}))
            triangles.insert({i, j, k});
        }
      }
    }
  }
  return triangles;
}

// Every conclusion from p to any planar P-data: its pairing is Proposition 13's, its six new attributes are free.
void TryTriangles(std::vector<R3Trial>& trials, const PData& p) {
  for (const Segments& s : Triangles(p)) {
    for (int choice = 0; choice < 64; ++choice) {
      const PData q = Repaired(p, s, {1 + choice % 4, 1 + choice / 4 % 4, 1 + choice / 16});
      if (!IsPlanar(q)) continue;
      const bool real = Realises(p, {MoveKind::kR3, MoveDirection::kShift, s}, q);
      const bool any = !DetectMoves(p, q).empty();
      for (size_t v = 0; v < trials.size(); ++v) {
        if (!AcceptsR3(p, q, s, R3Variants()[v].reading)) continue;
        ++trials[v].conclusions;
        trials[v].wrong += real ? 0 : 1;
        trials[v].wrong_pairs += any ? 0 : 1;
        if (!any) trials[v].least_wrong.Offer(p, q, {s.begin(), s.end()});
      }
    }
  }
}

std::vector<R3Trial> TryRules(Effort effort) {
  std::vector<R3Trial> trials(R3Variants().size());
  ForEachPlanarPDataTo(BoundsOf(effort).equal, [&](const PData& p) {
    for (const Move& move : AllMoves(p, p.crossings())) {
      if (move.kind != MoveKind::kR3) continue;
      for (size_t v = 0; v < trials.size(); ++v) TryMove(trials[v], p, move, R3Variants()[v].reading);
    }
    TryTriangles(trials, p);
  });
  // A random pair is not the least of its kind.
  std::vector<LeastPair<std::vector<int>>> least;
  for (const R3Trial& trial : trials) least.push_back(trial.least_wrong);
  ForEachRandomRope(effort, [&](const PData& p) { TryTriangles(trials, p); });
  for (size_t v = 0; v < trials.size(); ++v) trials[v].least_wrong = least[v];
  return trials;
}

}  // namespace

const std::vector<R3Trial>& R3TrialsTo(Effort effort) { return KeptFor<TryRules>(effort); }

}  // namespace tact::provers

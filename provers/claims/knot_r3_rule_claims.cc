// The thesis' rule for R_III, literally, in readings, and corrected.
#include <set>

#include "algebra/knot/thesis_rules.h"
#include "provers/claims/knot_move_claims.h"
#include "provers/claims/knot_world.h"
#include "provers/knot_certificate.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using knot::thesis::AcceptsR3;
using knot::thesis::R3Reading;
using knot::thesis::R3Triangle;
using Segments = std::array<int, 3>;

constexpr R3Reading kCorrected{R3Triangle::kFaces, true, true};

struct Variant {
  std::string name, file;
  R3Reading reading;
};
// From the least to the most that the words may ask for, all in the printed range; then what must be added.
const std::vector<Variant>& Variants() {
  static const std::vector<Variant> variants = {
      {"named by heights before", "named-before", {R3Triangle::kNamedBefore, false, false}},
      {"named by heights twice", "named-twice", {R3Triangle::kNamedTwice, false, false}},
      {"and the triangles are faces", "faces", {R3Triangle::kFaces, false, false}},
      {"and signs are kept", "faces-signs", {R3Triangle::kFaces, true, false}},
      {"the same, segment n too", "corrected", kCorrected},
      {"named twice, signs kept, segment n too", "signs-only", {R3Triangle::kNamedTwice, true, true}},
      {"faces, segment n too, signs not kept", "faces-whole-range", {R3Triangle::kFaces, false, true}}};
  return variants;
}

struct Trial {
  long long moves = 0, missed = 0, missed_inside = 0, conclusions = 0, wrong = 0, wrong_pairs = 0;
  LeastPair<Move> least_missed;
  LeastPair<Segments> least_wrong;

  bool holds() const { return missed + wrong == 0 && moves > 0; }
};

void TryMove(Trial& trial, const PData& p, const Move& move, const R3Reading& reading) {
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
void TryConclusions(std::vector<Trial>& trials, const PData& p) {
  for (const Segments& s : Triangles(p)) {
    for (int choice = 0; choice < 64; ++choice) {
      const PData q = Repaired(p, s, {1 + choice % 4, 1 + choice / 4 % 4, 1 + choice / 16});
      if (!IsPlanar(q)) continue;
      const bool real = Realises(p, {MoveKind::kR3, MoveDirection::kShift, s}, q);
      const bool any = !DetectMoves(p, q).empty();
      for (size_t v = 0; v < trials.size(); ++v) {
        if (!AcceptsR3(p, q, s, Variants()[v].reading)) continue;
        ++trials[v].conclusions;
        trials[v].wrong += real ? 0 : 1;
        trials[v].wrong_pairs += any ? 0 : 1;
        if (!any) trials[v].least_wrong.Offer(p, q, s);
      }
    }
  }
}

std::vector<Trial> TryRules(Effort effort) {
  std::vector<Trial> trials(Variants().size());
  ForEachPlanarPDataTo(BoundsOf(effort).equal, [&](const PData& p) {
    for (const Move& move : AllMoves(p, p.crossings())) {
      if (move.kind != MoveKind::kR3) continue;
      for (size_t v = 0; v < trials.size(); ++v) TryMove(trials[v], p, move, Variants()[v].reading);
    }
    TryConclusions(trials, p);
  });
  // A random pair is not the least of its kind.
  std::vector<LeastPair<Segments>> least;
  for (const Trial& trial : trials) least.push_back(trial.least_wrong);
  ForEachRandomRope(effort, [&](const PData& p) { TryConclusions(trials, p); });
  for (size_t v = 0; v < trials.size(); ++v) trials[v].least_wrong = least[v];
  return trials;
}

// One pass for the three claims.
const std::vector<Trial>& TrialsTo(Effort effort) {
  static const std::vector<Trial> quick = TryRules(Effort::kQuick);
  if (effort == Effort::kQuick) return quick;
  static const std::vector<Trial> standard = TryRules(Effort::kStandard);
  if (effort == Effort::kStandard) return standard;
  static const std::vector<Trial> full = TryRules(Effort::kFull);
  return full;
}

std::string Bound(Effort effort) {
  return AllPData(BoundsOf(effort).equal) +
         " and random ropes of 6 to 12, each with every P-data that the rule accepts";
}

std::string Text(const Segments& s) {
  return std::to_string(s[0]) + ", " + std::to_string(s[1]) + " and " + std::to_string(s[2]);
}

Outcome TryPrinted(Effort effort) {
  const std::string id = "thesis.5.3.3.r3-rule";
  Outcome outcome;
  outcome.bound = Bound(effort);
  Table table{"R_III in readings of \"compose a triangle\"",
              {"reading", "moves", "missed", "missed below segment n", "conclusions", "not such a move",
               "no R3 at all"},
              {}};
  bool holds = false;
  for (size_t i = 0; i < Variants().size(); ++i) {
    const Variant& v = Variants()[i];
    const Trial& trial = TrialsTo(effort)[i];
    if (!v.reading.last_segment) holds = holds || trial.holds();
    table.rows.push_back({v.name, std::to_string(trial.moves), std::to_string(trial.missed),
                          std::to_string(trial.missed_inside), std::to_string(trial.conclusions),
                          std::to_string(trial.wrong), std::to_string(trial.wrong_pairs)});
    outcome.numbers.emplace_back(v.name + ": moves missed", trial.missed);
    outcome.numbers.emplace_back(v.name + ": wrong conclusions", trial.wrong);
    if (trial.least_wrong.found) {
      outcome.evidence += "Wrong with \"" + v.name + "\", smallest: segments " +
                          Text(trial.least_wrong.more) + " from " + Show(trial.least_wrong.before) + " to " +
                          Show(trial.least_wrong.after) + ".\n\n";
      outcome.certificates.push_back(WrongRuleCertificate(
          id + ".wrong-" + v.file, id, RuleText(v.reading), trial.least_wrong.before,
          {trial.least_wrong.more.begin(), trial.least_wrong.more.end()}, trial.least_wrong.after));
    }
    if (trial.least_missed.found && v.file == "named-before") {
      outcome.evidence +=
          "Missed in every reading, smallest: segments " + Text(trial.least_missed.more.segments) + " from " +
          Show(trial.least_missed.before) + " to " + Show(trial.least_missed.after) +
          "; segment n is the last one between two intersections, and the printed range ends at n - 1.\n\n";
      outcome.certificates.push_back(MissedMoveCertificate(id + ".missed", id, RuleText(v.reading),
                                                           trial.least_missed.before, trial.least_missed.more,
                                                           trial.least_missed.after));
    }
  }
  outcome.tables = {table};
  outcome.verdict = holds ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.evidence +=
      "R_III(P, i, j, k) removes six columns, so what they say is never compared: neither their signs nor, "
      "after the move, which strand is over which. And three segments that meet pairwise need not bound a "
      "face: the rest of the rope may lie inside.\n\nCorrected: segments from 2 to n, signs and heights of "
      "each two segments' intersection kept, the triangle a face (thesis.5.3.3.r3-rule-corrected).";
  return outcome;
}

Outcome TryCorrected(Effort effort) {
  const Trial& trial = TrialsTo(effort)[4];
  long long random_moves = 0, random_missed = 0;
  ForEachRandomMove(effort, [&](const PData& p, const Move& move) {
    if (move.kind != MoveKind::kR3) return;
    ++random_moves;
    random_missed += AcceptsR3(p, Apply(p, move), move.segments, kCorrected) ? 0 : 1;
  });
  Outcome outcome;
  outcome.verdict = trial.holds() && random_missed == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (outcome.verdict == Verdict::kRefuted) outcome.no_certificate = "the pair was not kept";
  outcome.bound = Bound(effort);
  outcome.numbers = {
      {"moves from the faces", trial.moves},   {"moves missed", trial.missed},
      {"moves of random ropes", random_moves}, {"of these missed", random_missed},
      {"conclusions", trial.conclusions},      {"conclusions without such a move", trial.wrong}};
  outcome.evidence =
      "Segments from 2 to n, named by heights at both times, of a permitted transition between types, "
      "signs kept, the rest equal, and the triangle a face: what is found is just what the faces admit.";
  return outcome;
}

// Is the face needed once heights and signs are kept?
Outcome TryFace(Effort effort) {
  const std::string id = "thesis.5.3.3.triangle-is-a-face";
  const R3Reading& reading = Variants()[5].reading;
  const Trial& trial = TrialsTo(effort)[5];
  Outcome outcome;
  outcome.bound = Bound(effort);
  outcome.numbers = {{"conclusions", trial.conclusions}, {"where no face is", trial.wrong}};
  outcome.verdict = trial.wrong == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (trial.least_wrong.found) {
    outcome.evidence = "Smallest: segments " + Text(trial.least_wrong.more) + " from " +
                       Show(trial.least_wrong.before) + " to " + Show(trial.least_wrong.after) + ".";
    outcome.certificates = {WrongRuleCertificate(
        id + ".inside", id, RuleText(reading), trial.least_wrong.before,
        {trial.least_wrong.more.begin(), trial.least_wrong.more.end()}, trial.least_wrong.after)};
  } else {
    outcome.no_certificate = "the pair was not kept";
    outcome.evidence = "That both P-data lie on a sphere is enough to tell that the triangle is a face.";
  }
  return outcome;
}

}  // namespace

std::vector<Claim> KnotR3RuleClaims() {
  return {{"thesis.5.3.3.r3-rule",
           "A Reidemeister move III occurs among the i-th, j-th and k-th segments just if they compose a "
           "triangle before and after, 2 <= i, j, k <= n - 1, by a permitted transition between their "
           "types, and R_III(P_t, i, j, k) = R_III(P_{t-1}, i, j, k).",
           "5.3.3", "exhaustive", TryPrinted},
          {"thesis.5.3.3.r3-rule-corrected",
           "The rule for the Reidemeister move III with segments up to n, kept signs and a face as "
           "triangle is sound and complete.",
           "5.3.3, corrected", "exhaustive", TryCorrected},
          {"thesis.5.3.3.triangle-is-a-face",
           "Where the corrected rule's other conditions hold for two P-data, the triangle is a face.",
           "5.3.3, step 1", "exhaustive", TryFace}};
}

}  // namespace tact::provers

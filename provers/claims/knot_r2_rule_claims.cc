// The thesis' rule for R_II, literally, in readings, and corrected.
#include <map>
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
using knot::thesis::FindR2;
using knot::thesis::R2Reading;
using Segments = std::pair<int, int>;

constexpr R2Reading kPrinted{true, true, false};
constexpr R2Reading kCorrected{true, true, true};

bool IsR2Addition(const Move& move) {
  return move.kind == MoveKind::kR2 && move.direction == MoveDirection::kAdd;
}

struct Completeness {
  long long moves = 0, missed = 0, missed_others = 0, random_moves = 0, random_missed = 0;
  LeastPair<Move> least;
};

Completeness TryCompleteness(const R2Reading& reading, Effort effort) {
  Completeness trial;
  const auto finds = [&](const PData& p, const Move& move, const PData& q) {
    const auto found = FindR2(p, q, reading);
    return std::find(found.begin(), found.end(), Segments(move.segments[0], move.segments[1])) != found.end();
  };
  ForEachPlanarPDataTo(BoundsOf(effort).smaller, [&](const PData& p) {
    for (const Move& move : AllMoves(p, p.crossings() + 2)) {
      if (!IsR2Addition(move)) continue;
      ++trial.moves;
      const PData q = Apply(p, move);
      if (finds(p, move, q)) continue;
      ++trial.missed;
      trial.missed_others += move.segments[0] != move.segments[1] ? 1 : 0;
      trial.least.Offer(p, q, move);
    }
  });
  ForEachRandomMove(effort, [&](const PData& p, const Move& move) {
    if (!IsR2Addition(move)) return;
    ++trial.random_moves;
    if (finds(p, move, Apply(p, move))) return;
    ++trial.random_missed;
    trial.missed_others += move.segments[0] != move.segments[1] ? 1 : 0;
  });
  return trial;
}

struct Soundness {
  long long conclusions = 0, wrong = 0;
  LeastPair<Segments> least;  // of those with no R2 at all between the two
};

bool AnyR2(const PData& before, const PData& p_t) {
  const auto moves = DetectMoves(before, p_t);
  return std::any_of(moves.begin(), moves.end(), IsR2Addition);
}

// Whatever the rule accepts about p_t: all removals that (5.5) or (5.6) allow.
Soundness TrySoundness(const R2Reading& reading, Effort effort) {
  Soundness trial;
  const auto conclude = [&](const PData& p_t) {
    std::set<PData> removals;
    for (int i = 1; i + 3 <= p_t.columns(); ++i) {
      const int first = p_t.sigma(i), second = p_t.sigma(i + 1), j = std::min(first, second) - 2;
      if (std::abs(first - second) == 1 && j >= i) removals.insert(knot::thesis::RemoveR2(p_t, i, j));
    }
    for (const PData& before : removals) {
      if (!IsPlanar(before)) continue;
      for (const auto& [i, j] : FindR2(before, p_t, reading)) {
        ++trial.conclusions;
        const bool opposite = p_t.sigma(i) > p_t.sigma(i + 1);
        const Move move{MoveKind::kR2, MoveDirection::kAdd, {i, j, 0}, {}, p_t.attr(i), opposite};
        if (Realises(before, move, p_t)) continue;
        ++trial.wrong;
        if (!AnyR2(before, p_t)) trial.least.Offer(before, p_t, {i, j});
      }
    }
  };
  ForEachPlanarPDataTo(BoundsOf(effort).larger, conclude);
  const LeastPair<Segments> least = trial.least;  // a random pair is not the least of its kind
  ForEachRandomRope(effort, conclude);
  trial.least = least;
  return trial;
}

std::string Bound(Effort effort) {
  return "every R2 from " + AllPData(BoundsOf(effort).smaller) + "; every conclusion about " +
         AllPData(BoundsOf(effort).larger) + "; both for random ropes of 6 to 12";
}

Outcome TryPrinted(Effort effort) {
  const std::string id = "thesis.5.3.2.r2-rule";
  const Completeness complete = TryCompleteness(kPrinted, effort);
  const Soundness sound = TrySoundness(kPrinted, effort);
  Outcome outcome;
  outcome.verdict = complete.missed + sound.wrong == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.bound = Bound(effort);
  outcome.numbers = {{"moves from the faces", complete.moves},
                     {"moves missed", complete.missed},
                     {"moves missed with i < j", complete.missed_others},
                     {"moves of random ropes", complete.random_moves},
                     {"of these missed", complete.random_missed},
                     {"conclusions", sound.conclusions},
                     {"conclusions without such a move", sound.wrong}};
  outcome.evidence =
      "Sound, not complete: a segment can be laid over itself, as when the rope's end is folded back onto "
      "its own segment, and then i = j, which the printed range 1 <= i < j leaves out. Nothing else is "
      "missed.";
  if (complete.least.found) {
    outcome.evidence += "\n\nSmallest: from " + Show(complete.least.before) + " to " +
                        Show(complete.least.after) + ", segment " +
                        std::to_string(complete.least.more.segments[0]) + " with itself.";
    outcome.certificates = {MissedMoveCertificate(id + ".missed", id, RuleText(kPrinted),
                                                  complete.least.before, complete.least.more,
                                                  complete.least.after)};
  }
  outcome.evidence += "\n\nCorrected: 1 <= i <= j <= n(P(t-1)) + 1 (thesis.5.3.2.r2-rule-corrected).";
  return outcome;
}

Outcome TryCorrected(Effort effort) {
  const Completeness complete = TryCompleteness(kCorrected, effort);
  const Soundness sound = TrySoundness(kCorrected, effort);
  Outcome outcome;
  outcome.verdict =
      complete.missed + complete.random_missed + sound.wrong == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (outcome.verdict == Verdict::kRefuted) outcome.no_certificate = "the pair was not kept";
  outcome.bound = Bound(effort);
  outcome.numbers = {{"moves from the faces", complete.moves},
                     {"moves missed", complete.missed},
                     {"moves of random ropes", complete.random_moves},
                     {"of these missed", complete.random_missed},
                     {"conclusions", sound.conclusions},
                     {"conclusions without such a move", sound.wrong}};
  outcome.evidence =
      "The rule with i = j allowed finds every R2 that the faces of P(t-1) admit, with its segments, and "
      "concludes no other. That the two segments lie on one face need not be asked for.";
  return outcome;
}

Outcome TryConditions(Effort effort) {
  const std::string id = "thesis.5.3.2.heights-and-signs";
  struct Variant {
    std::string name, file;
    R2Reading reading;
  };
  const std::vector<Variant> variants = {{"(5.7)", "both", {true, true, false}},
                                         {"same heights only", "heights", {true, false, false}},
                                         {"different signs only", "signs", {false, true, false}},
                                         {"neither", "neither", {false, false, false}}};
  Outcome outcome;
  outcome.bound =
      "every conclusion about " + AllPData(BoundsOf(effort).larger) + " and about random ropes of 6 to 12";
  Table table{
      "R_II as printed, and with less than (5.7)", {"asked for", "conclusions", "without such a move"}, {}};
  bool all_needed = true;
  for (const Variant& v : variants) {
    const Soundness sound = TrySoundness(v.reading, effort);
    table.rows.push_back({v.name, std::to_string(sound.conclusions), std::to_string(sound.wrong)});
    outcome.numbers.emplace_back("wrong with " + v.name, sound.wrong);
    const bool is_printed = v.file == "both";
    if (is_printed) all_needed = all_needed && sound.wrong == 0;
    if (is_printed || !sound.least.found) {
      all_needed = all_needed && (is_printed || sound.wrong > 0);
      continue;
    }
    outcome.evidence += "With " + v.name + ", smallest wrong conclusion: from " + Show(sound.least.before) +
                        " to " + Show(sound.least.after) + ", segments " +
                        std::to_string(sound.least.more.first) + " and " +
                        std::to_string(sound.least.more.second) + ".\n\n";
    outcome.certificates.push_back(
        WrongRuleCertificate(id + "." + v.file, id, RuleText(v.reading), sound.least.before,
                             {sound.least.more.first, sound.least.more.second}, sound.least.after));
  }
  outcome.tables = {table};
  outcome.verdict = all_needed && !outcome.certificates.empty() ? Verdict::kProved : Verdict::kUndecided;
  outcome.evidence +=
      "Both halves of (5.7) are needed. The signs differ by themselves where the strands meet the two "
      "intersections in the same order, (5.5): the rope leaves the closed curve of the two segments on one "
      "side only. In opposite order, (5.6), it may enter on one side and leave on the other.";
  return outcome;
}

// The signs in the two orders, whatever the heights.
Outcome TrySigns(Effort effort) {
  long long same = 0, opposite = 0, same_sign_same = 0, same_sign_opposite = 0;
  ForEachPlanarPDataTo(BoundsOf(effort).larger, [&](const PData& p) {
    for (int i = 1; i < p.columns(); ++i) {
      const int first = p.sigma(i), second = p.sigma(i + 1);
      if (std::min(first, second) <= i + 1 || std::abs(first - second) != 1) continue;
      // Heights apart: crossing to the same side twice.
      const bool equal = p.turn(i) == p.turn(i + 1);
      ++(first < second ? same : opposite);
      if (equal) ++(first < second ? same_sign_same : same_sign_opposite);
    }
  });
  Outcome outcome;
  outcome.bound = AllPData(BoundsOf(effort).larger);
  outcome.numbers = {{"pairs as in (5.5)", same},
                     {"as in (5.5), crossed to one side twice", same_sign_same},
                     {"pairs as in (5.6)", opposite},
                     {"as in (5.6), crossed to one side twice", same_sign_opposite}};
  outcome.verdict = same_sign_same == 0 && same > 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (outcome.verdict == Verdict::kRefuted) outcome.no_certificate = "the pair was not kept";
  outcome.evidence =
      "Why: the two segments make a closed curve without other intersections. At each of its two corners "
      "the rope's other two strands leave to one side. In the order of (5.5) the piece of rope from the "
      "second corner's first passage to the first corner's second one joins the two sides, so they are one "
      "and the lens is empty. In the order of (5.6) the corners' strands are joined to each other or end, "
      "and the sides may differ.";
  return outcome;
}

Outcome TryFormula(Effort effort) {
  long long tried = 0, wrong = 0, most = 0, columns = 0;
  ForEachPlanarPDataTo(BoundsOf(effort).larger, [&](const PData& p) {
    long long candidates = 0;
    for (int i = 1; i < p.columns(); ++i) {
      for (int j = i; j + 3 <= p.columns(); ++j) {
        const int first = p.sigma(i), second = p.sigma(i + 1);
        if (!(first == j + 2 && second == j + 3) && !(first == j + 3 && second == j + 2)) continue;
        ++tried;
        ++candidates;
        wrong += 2 * j == first + second - 5 ? 0 : 1;
      }
    }
    if (candidates > most) {
      most = candidates;
      columns = p.columns();
    }
  });
  Outcome outcome;
  outcome.verdict = wrong == 0 ? Verdict::kProved : Verdict::kRefuted;
  outcome.no_certificate = "a line of arithmetic";
  outcome.bound = "complete; tried on " + AllPData(BoundsOf(effort).larger);
  outcome.numbers = {{"places i, j", tried},
                     {"wrong", wrong},
                     {"most in one P-data", most},
                     {"of so many columns", columns}};
  outcome.evidence =
      "In either order sigma(i) + sigma(i+1) = 2 j + 5. So each i has one j at most and there are fewer "
      "than n(P(t)) places to try. Each comparison is O(n), as the thesis' footnote says, so the rule as "
      "it stands takes O(n^2) where many places pass (5.5)-(5.7), as in a strand woven over another one. "
      "DetectMoves takes one pass from each side and then decides each place in constant time.";
  return outcome;
}

Outcome TryFigure(Effort effort) {
  const std::string id = "thesis.5.3.2.figure-5.11";
  const std::vector<Segments> wanted = {{1, 4}, {2, 5}, {3, 6}};
  const int crossings = effort == Effort::kFull ? 5 : 3;
  long long pairs = 0, several = 0, most = 0, exactly = 0;
  std::set<PData> starts;
  LeastPair<std::vector<Move>> least;
  ForEachPlanarPDataTo(crossings, [&](const PData& p) {
    std::map<PData, std::vector<Move>> reached;
    for (const Move& move : AllMoves(p, p.crossings() + 2)) {
      if (IsR2Addition(move)) reached[Apply(p, move)].push_back(move);
    }
    for (const auto& [q, moves] : reached) {
      ++pairs;
      several += moves.size() > 1 ? 1 : 0;
      most = std::max(most, static_cast<long long>(moves.size()));
      if (moves.size() != 3 || FindR2(p, q) != wanted) continue;
      ++exactly;
      starts.insert(p);
      least.Offer(p, q, moves);
    }
  });
  Outcome outcome;
  outcome.bound = AllPData(crossings) + " before the move";
  outcome.numbers = {{"pairs that an R2 explains", pairs},
                     {"pairs that several explain", several},
                     {"most R2 for one pair", most},
                     {"pairs that just 1-4, 2-5, 3-6 explain", exactly},
                     {"P-data they start from", static_cast<long long>(starts.size())}};
  if (!least.found) {
    outcome.evidence = "None to this bound.";
    return outcome;
  }
  outcome.verdict = Verdict::kProved;
  outcome.evidence =
      "The figure itself is lost; P-data for which exactly these three come out do exist. Smallest: from " +
      Show(least.before) + " to " + Show(least.after) + ".";
  for (const Move& move : least.more) {
    const std::string at = std::to_string(move.segments[0]) + "-" + std::to_string(move.segments[1]);
    outcome.certificates.push_back(
        KnotMoveCertificate(id + ".at-" + at, id, least.before, move, least.after));
  }
  return outcome;
}

}  // namespace

std::vector<Claim> KnotR2RuleClaims() {
  return {
      {"thesis.5.3.2.r2-rule",
       "A Reidemeister move II occurs between the i-th and j-th segments just if (5.4), (5.5) or (5.6), "
       "(5.7) and R_II(P_t, i, j) = P_{t-1} hold for i, j with 1 <= i < j <= n(P_{t-1}) + 1.",
       "5.3.2", "exhaustive", TryPrinted},
      {"thesis.5.3.2.r2-rule-corrected",
       "The rule for the Reidemeister move II with i <= j is sound and complete.", "5.3.2, corrected",
       "exhaustive", TryCorrected},
      {"thesis.5.3.2.heights-and-signs",
       "Of the two intersections that a Reidemeister move II adds, both halves of (5.7) must be asked for: "
       "the same heights and different signs.",
       "5.3.2, (5.7)", "exhaustive", TryConditions},
      {"thesis.5.3.2.signs-by-order",
       "Where two segments meet twice in a row in the order of (5.5), the second intersection leads back "
       "to the side that the first one left.",
       "5.3.2, (5.5)-(5.7)", "exhaustive", TrySigns},
      {"thesis.5.3.2.r2-formula",
       "j = (sigma(i) + sigma(i+1) - 5) / 2, so O(n) places need be tried, with a comparison of O(n) each.",
       "5.3.2", "symbolic", TryFormula},
      {"thesis.5.3.2.figure-5.11",
       "There is a transition that Reidemeister moves II of just the third and sixth, the first and "
       "fourth, or the second and fifth segments explain.",
       "5.3.2, Figure 5.11", "exhaustive", TryFigure}};
}

}  // namespace tact::provers

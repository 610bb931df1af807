// The thesis' rule for R_III, literally, in readings, and corrected.
#include "provers/claims/knot_move_claims.h"
#include "provers/claims/knot_r3_trial.h"
#include "provers/knot_certificate.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveKind;
using knot::PData;

std::string Bound(Effort effort) {
  return AllPData(BoundsOf(effort).equal) +
         " and random ropes of 6 to 12, each with every P-data that the rule accepts";
}

template <typename Segments>
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
  for (size_t i = 0; i < R3Variants().size(); ++i) {
    const R3Variant& v = R3Variants()[i];
    const R3Trial& trial = R3TrialsTo(effort)[i];
    if (!v.reading.last_segment) holds = holds || (trial.complete() && trial.sound());
    table.rows.push_back({v.name, std::to_string(trial.moves), std::to_string(trial.missed),
                          std::to_string(trial.missed_inside), std::to_string(trial.conclusions),
                          std::to_string(trial.wrong), std::to_string(trial.wrong_pairs)});
    outcome.numbers.emplace_back(v.name + ": moves missed", trial.missed);
    outcome.numbers.emplace_back(v.name + ": wrong conclusions", trial.wrong);
    if (trial.least_wrong.found) {
      outcome.evidence += "Wrong with \"" + v.name + "\", smallest: segments " +
                          Text(trial.least_wrong.more) + " from " + Show(trial.least_wrong.before) + " to " +
                          Show(trial.least_wrong.after) + ".\n\n";
      outcome.certificates.push_back(WrongRuleCertificate(id + ".wrong-" + v.file, id, RuleText(v.reading),
                                                          trial.least_wrong.before, trial.least_wrong.more,
                                                          trial.least_wrong.after));
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
  R3Trial trial = R3TrialsTo(effort)[kR3Corrected];
  ForEachRandomMove(effort, [&](const PData& p, const Move& move) {
    if (move.kind != MoveKind::kR3) return;
    ++trial.random_moves;
    const auto& reading = R3Variants()[kR3Corrected].reading;
    trial.random_missed += AcceptsR3(p, Apply(p, move), move.segments, reading) ? 0 : 1;
  });
  Outcome outcome;
  outcome.verdict = trial.complete() && trial.sound() ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (outcome.verdict == Verdict::kRefuted) outcome.no_certificate = "the pair was not kept";
  outcome.bound = Bound(effort);
  outcome.numbers = Numbers(trial);
  outcome.evidence =
      "Segments from 2 to n, named by heights at both times, of a permitted transition between types, "
      "signs kept, the rest equal, and the triangle a face: what is found is just what the faces admit.";
  return outcome;
}

// Is the face needed once heights and signs are kept?
Outcome TryFace(Effort effort) {
  const std::string id = "thesis.5.3.3.triangle-is-a-face";
  const R3Trial& trial = R3TrialsTo(effort)[kR3SignsOnly];
  Outcome outcome;
  outcome.bound = Bound(effort);
  outcome.numbers = {{"conclusions", trial.conclusions}, {"where no face is", trial.wrong}};
  outcome.verdict = trial.wrong == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (trial.least_wrong.found) {
    outcome.evidence = "Smallest: segments " + Text(trial.least_wrong.more) + " from " +
                       Show(trial.least_wrong.before) + " to " + Show(trial.least_wrong.after) + ".";
    outcome.certificates = {
        WrongRuleCertificate(id + ".inside", id, RuleText(R3Variants()[kR3SignsOnly].reading),
                             trial.least_wrong.before, trial.least_wrong.more, trial.least_wrong.after)};
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

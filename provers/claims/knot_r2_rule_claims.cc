// The thesis' rule for R_II, literally, in readings, and corrected.
#include <set>

#include "algebra/knot/thesis_rules.h"
#include "provers/claims/knot_move_claims.h"
#include "provers/claims/knot_rule_trial.h"
#include "provers/knot_certificate.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using knot::thesis::FindR2;
using knot::thesis::R2Reading;

constexpr R2Reading kPrinted{true, true, false};
constexpr R2Reading kCorrected{true, true, true};

// Besides, the moves missed that are not of a segment with itself.
struct R2Trial : RuleTrial {
  long long missed_others = 0;
};

bool AnyR2(const PData& before, const PData& p_t) {
  const auto moves = DetectMoves(before, p_t);
  return std::any_of(moves.begin(), moves.end(), [](const Move& move) { return Adds(move, MoveKind::kR2); });
}

// Whatever the rule accepts about p_t: all removals that (5.5) or (5.6) allow.
void Conclude(RuleTrial& trial, const R2Reading& reading, const PData& p_t) {
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
      if (!AnyR2(before, p_t)) trial.least_wrong.Offer(before, p_t, {i, j});
    }
  }
}
void TrySoundness(RuleTrial& trial, const R2Reading& reading, Effort effort) {
  TryConclusions(trial, effort, [&](const PData& p_t) { Conclude(trial, reading, p_t); });
}

R2Trial TryRule(const R2Reading& reading, Effort effort) {
  R2Trial trial;
  TryMoves(trial, MoveKind::kR2, effort, [&](const PData& p, const Move& move, const PData& q) {
    const auto found = FindR2(p, q, reading);
    const std::pair segments(move.segments[0], move.segments[1]);
    const bool finds = std::find(found.begin(), found.end(), segments) != found.end();
    trial.missed_others += !finds && segments.first != segments.second ? 1 : 0;
    return finds;
  });
  TrySoundness(trial, reading, effort);
  return trial;
}

Outcome TryPrinted(Effort effort) {
  const std::string id = "thesis.5.3.2.r2-rule";
  const R2Trial trial = TryRule(kPrinted, effort);
  Outcome outcome;
  outcome.verdict = trial.missed + trial.wrong == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.bound = RuleBound("R2", effort);
  outcome.numbers = Numbers(trial);
  outcome.numbers.insert(outcome.numbers.begin() + 2, {"moves missed with i < j", trial.missed_others});
  outcome.evidence =
      "Sound, not complete: a segment can be laid over itself, as when the rope's end is folded back onto "
      "its own segment, and then i = j, which the printed range 1 <= i < j leaves out. Nothing else is "
      "missed.";
  if (trial.least_missed.found) {
    const auto& [found, before, after, move] = trial.least_missed;
    outcome.evidence += "\n\nSmallest: from " + Show(before) + " to " + Show(after) + ", segment " +
                        std::to_string(move.segments[0]) + " with itself.";
    outcome.certificates = {
        MissedMoveCertificate(id + ".missed", id, RuleText(kPrinted), before, move, after)};
  }
  outcome.evidence += "\n\nCorrected: 1 <= i <= j <= n(P(t-1)) + 1 (thesis.5.3.2.r2-rule-corrected).";
  return outcome;
}

Outcome TryCorrected(Effort effort) {
  const R2Trial trial = TryRule(kCorrected, effort);
  Outcome outcome;
  outcome.verdict = trial.complete() && trial.sound() ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (outcome.verdict == Verdict::kRefuted) outcome.no_certificate = "the pair was not kept";
  outcome.bound = RuleBound("R2", effort);
  outcome.numbers = Numbers(trial);
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
    RuleTrial sound;
    TrySoundness(sound, v.reading, effort);
    table.rows.push_back({v.name, std::to_string(sound.conclusions), std::to_string(sound.wrong)});
    outcome.numbers.emplace_back("wrong with " + v.name, sound.wrong);
    const bool is_printed = v.file == "both";
    if (is_printed) all_needed = all_needed && sound.wrong == 0;
    if (is_printed || !sound.least_wrong.found) {
      all_needed = all_needed && (is_printed || sound.wrong > 0);
      continue;
    }
    const auto& [found, before, after, segments] = sound.least_wrong;
    outcome.evidence += "With " + v.name + ", smallest wrong conclusion: from " + Show(before) + " to " +
                        Show(after) + ", segments " + std::to_string(segments[0]) + " and " +
                        std::to_string(segments[1]) + ".\n\n";
    outcome.certificates.push_back(
        WrongRuleCertificate(id + "." + v.file, id, RuleText(v.reading), before, segments, after));
  }
  outcome.tables = {table};
  outcome.verdict = all_needed && !outcome.certificates.empty() ? Verdict::kProved : Verdict::kUndecided;
  outcome.evidence +=
      "Both halves of (5.7) are needed. The signs differ by themselves where the strands meet the two "
      "intersections in the same order, (5.5): the rope leaves the closed curve of the two segments on one "
      "side only. In opposite order, (5.6), it may enter on one side and leave on the other.";
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
       "5.3.2, (5.7)", "exhaustive", TryConditions}};
}

}  // namespace tact::provers

// The thesis' rules for R_I and the Cross move, literally.
#include <map>

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
using knot::RopeEnd;

// The moves that a rule concludes: the segments from the rule, the rest from p_t's new columns.
std::vector<Move> ConcludeR1(const PData& before, const PData& after) {
  std::vector<Move> moves;
  for (const int i : knot::thesis::FindR1(before, after))
    moves.push_back({MoveKind::kR1, MoveDirection::kAdd, {i, 0, 0}, {}, after.attr(i)});
  return moves;
}

std::vector<Move> ConcludeCross(const PData& before, const PData& after) {
  std::vector<Move> moves;
  if (const auto i = knot::thesis::FindCrossAtSelectiveEnd(before, after))
    moves.push_back({MoveKind::kCross, MoveDirection::kAdd, {*i, 0, 0}, RopeEnd::kSelective, after.attr(1)});
  if (const auto j = knot::thesis::FindCrossAtOtherEnd(before, after)) {
    const int attr = after.attr(after.columns());
    moves.push_back({MoveKind::kCross, MoveDirection::kAdd, {*j, 0, 0}, RopeEnd::kOther, attr});
  }
  return moves;
}

using Rule = std::vector<Move> (*)(const PData&, const PData&);

// Every P-data that the rule's removal can give from p_t.
std::vector<PData> Removals(MoveKind kind, const PData& p_t) {
  std::vector<PData> removals;
  if (kind == MoveKind::kR1) {
    for (int i = 1; i < p_t.columns(); ++i) {
      if (p_t.sigma(i) == i + 1) removals.push_back(knot::thesis::RemoveR1(p_t, i));
    }
  } else if (p_t.columns() > 0) {
    removals = {knot::thesis::RemoveCrossAtSelectiveEnd(p_t), knot::thesis::RemoveCrossAtOtherEnd(p_t)};
  }
  std::sort(removals.begin(), removals.end());
  removals.erase(std::unique(removals.begin(), removals.end()), removals.end());
  return removals;
}

RuleTrial TryRule(MoveKind kind, Rule rule, Effort effort) {
  RuleTrial trial;
  TryMoves(trial, kind, effort, [&](const PData& p, const Move& move, const PData& q) {
    const auto found = rule(p, q);
    return std::find(found.begin(), found.end(), move) != found.end();
  });
  TryConclusions(trial, effort, [&](const PData& p_t) {
    for (const PData& before : Removals(kind, p_t)) {
      for (const Move& move : rule(before, p_t)) {
        ++trial.conclusions;
        trial.wrong += IsPlanar(before) && Realises(before, move, p_t) ? 0 : 1;
      }
    }
  });
  return trial;
}

Outcome Judge(const RuleTrial& trial, Effort effort, const std::string& more) {
  Outcome outcome;
  const bool holds = trial.complete() && trial.sound() && trial.conclusions > 0;
  outcome.verdict = holds ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (!holds) outcome.no_certificate = "the pair was not kept";
  outcome.bound = RuleBound("such move", effort);
  outcome.numbers = {{"moves from the faces", trial.moves},
                     {"moves of random ropes", trial.random_moves},
                     {"moves missed", trial.missed + trial.random_missed},
                     {"conclusions", trial.conclusions},
                     {"conclusions without such a move", trial.wrong}};
  outcome.evidence =
      "Complete: each move that the faces of P(t-1) admit is concluded from the pair that it makes, with "
      "its segment. Sound: whatever the rule concludes from P(t) and any P(t-1) is possible by the faces "
      "of P(t-1) and gives P(t).\n\n" +
      more;
  return outcome;
}

Outcome TryR1(Effort effort) {
  return Judge(
      TryRule(MoveKind::kR1, ConcludeR1, effort), effort,
      "Both ends of the range are needed: i = 1 and i = n(P(t-1)) + 1 are kinks of the end segments. The "
      "rule names the segment only; which of the four kinks it is, attr(i) of P(t) says.");
}

Outcome TryCross(Effort effort) {
  return Judge(
      TryRule(MoveKind::kCross, ConcludeCross, effort), effort,
      "Both renumberings are right as printed, and so are the segments concluded. That the crossed segment "
      "lies on the end's face need not be asked for: P(t) being P-data of a diagram is enough.");
}

Outcome TrySeveralWays(Effort effort) {
  const std::string id = "thesis.5.3.1.several-ways";
  long long pairs = 0, several = 0, kinks_differ = 0, most = 0;
  LeastPair<std::vector<Move>> least;
  ForEachPlanarPDataTo(BoundsOf(effort).smaller, [&](const PData& p) {
    std::map<PData, std::vector<Move>> reached;
    for (const Move& move : AllMoves(p, p.crossings() + 1)) {
      if (Adds(move, MoveKind::kR1)) reached[Apply(p, move)].push_back(move);
    }
    for (const auto& [q, moves] : reached) {
      ++pairs;
      most = std::max(most, static_cast<long long>(moves.size()));
      if (moves.size() < 2) continue;
      ++several;
      kinks_differ += moves.front().attr != moves.back().attr ? 1 : 0;
      least.Offer(p, q, moves);
    }
  });
  Outcome outcome;
  outcome.bound = AllPData(BoundsOf(effort).smaller) + " before the move";
  outcome.numbers = {{"pairs that an R1 explains", pairs},
                     {"pairs that several explain", several},
                     {"of these, with kinks of different attributes", kinks_differ},
                     {"most R1 for one pair", most}};
  if (!least.found) return outcome;
  outcome.verdict = Verdict::kProved;
  outcome.evidence = "Smallest: from " + Show(least.before) + " to " + Show(least.after) +
                     ", a second kink before or after the first one.";
  for (const Move& move : least.more) {
    outcome.certificates.push_back(KnotMoveCertificate(id + ".at-" + std::to_string(move.segments[0]), id,
                                                       least.before, move, least.after));
  }
  return outcome;
}

}  // namespace

std::vector<Claim> KnotR1CrossRuleClaims() {
  return {
      {"thesis.5.3.1.r1-rule",
       "A Reidemeister move I occurs at the i-th segment just if (5.2), (5.3) and R_I(P_t, i) = P_{t-1} "
       "hold for an i from 1 to n(P_{t-1}) + 1.",
       "5.3.1", "exhaustive", TryR1},
      {"thesis.5.3.1.several-ways",
       "Several Reidemeister moves I may exist that realise one transition of P-data.", "5.3.1", "exhaustive",
       TrySeveralWays},
      {"thesis.5.3.4.cross-rule",
       "A Cross move of the selective end over or under segment sigma(1) - 1, or of the other end over or "
       "under segment sigma(n), occurs just if C_s(P_t) = P_{t-1}, or C_e(P_t) = P_{t-1}.",
       "5.3.4", "exhaustive", TryCross}};
}

}  // namespace tact::provers

// Where an R_II takes place: the signs in the two orders, the formula for j, Figure 5.11.
#include <map>
#include <set>

#include "algebra/knot/thesis_rules.h"
#include "provers/claims/knot_move_claims.h"
#include "provers/claims/knot_rule_trial.h"
#include "provers/knot_certificate.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveKind;
using knot::PData;

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
  const std::vector<std::pair<int, int>> wanted = {{1, 4}, {2, 5}, {3, 6}};
  const int crossings = effort == Effort::kFull ? 5 : 3;
  long long pairs = 0, several = 0, most = 0, exactly = 0;
  std::set<PData> starts;
  LeastPair<std::vector<Move>> least;
  ForEachPlanarPDataTo(crossings, [&](const PData& p) {
    std::map<PData, std::vector<Move>> reached;
    for (const Move& move : AllMoves(p, p.crossings() + 2)) {
      if (Adds(move, MoveKind::kR2)) reached[Apply(p, move)].push_back(move);
    }
    for (const auto& [q, moves] : reached) {
      ++pairs;
      several += moves.size() > 1 ? 1 : 0;
      most = std::max(most, static_cast<long long>(moves.size()));
      if (moves.size() != 3 || knot::thesis::FindR2(p, q) != wanted) continue;
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

std::vector<Claim> KnotR2PlaceClaims() {
  return {
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

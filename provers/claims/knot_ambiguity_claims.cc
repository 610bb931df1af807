// Transitions that several kinds of moves, or both choices of the selective end, explain; Propositions 14 and 15.
#include <map>

#include "provers/claims/knot_move_claims.h"
#include "provers/claims/knot_world.h"
#include "provers/knot_certificate.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using knot::RopeEnd;

// Where the moves that add or shift lead from p, and which of them lead there.
std::map<PData, std::vector<Move>> Reached(const PData& p, int most_more) {
  std::map<PData, std::vector<Move>> reached;
  for (const Move& move : AllMoves(p, p.crossings() + most_more)) {
    if (move.direction != MoveDirection::kRemove) reached[Apply(p, move)].push_back(move);
  }
  return reached;
}

bool Has(const std::vector<Move>& moves, MoveKind kind) {
  return std::any_of(moves.begin(), moves.end(), [&](const Move& m) { return m.kind == kind; });
}

void AddCertificates(Outcome& outcome, const std::string& id, const PData& p, const std::vector<Move>& moves,
                     const PData& q) {
  for (size_t k = 0; k < moves.size(); ++k)
    outcome.certificates.push_back(
        KnotMoveCertificate(id + ".way-" + std::to_string(k + 1), id, p, moves[k], q));
}

Outcome TryKinds(Effort effort) {
  const std::string id = "thesis.5.2.kinds-overlap";
  long long pairs = 0, both = 0, crosses = 0, others = 0;
  LeastPair<std::vector<Move>> least;
  ForEachPlanarPDataTo(BoundsOf(effort).smaller, [&](const PData& p) {
    for (const auto& [q, moves] : Reached(p, 2)) {
      ++pairs;
      const bool r1 = Has(moves, MoveKind::kR1), cross = Has(moves, MoveKind::kCross);
      others += (r1 || cross) + Has(moves, MoveKind::kR2) + Has(moves, MoveKind::kR3) > 1 ? 1 : 0;
      crosses += std::count_if(moves.begin(), moves.end(),
                               [](const Move& m) { return m.kind == MoveKind::kCross; }) > 1;
      if (!r1 || !cross) continue;
      ++both;
      least.Offer(p, q, moves);
    }
  });
  Outcome outcome;
  outcome.bound = AllPData(BoundsOf(effort).smaller) + " before the move";
  outcome.numbers = {{"pairs that a move explains", pairs},
                     {"pairs that R1 and Cross explain", both},
                     {"pairs that Cross moves of both ends explain", crosses},
                     {"pairs that other two kinds explain", others}};
  outcome.verdict = least.found && others == 0 ? Verdict::kProved : Verdict::kRefuted;
  outcome.evidence =
      "R1 and Cross change the number of intersections by one, R2 by two, R3 by none: no other two kinds "
      "can meet. Smallest: from " +
      Show(least.before) + " to " + Show(least.after) + ".";
  AddCertificates(outcome, id, least.before, least.more, least.after);
  return outcome;
}

Outcome TryCrossOrR1(Effort effort) {
  const std::string id = "thesis.5.3.4.cross-or-r1";
  long long at_end = 0, at_end_without_cross = 0, both = 0, both_inside = 0;
  LeastPair<std::vector<Move>> least;
  ForEachPlanarPDataTo(BoundsOf(effort).smaller, [&](const PData& p) {
    for (const auto& [q, moves] : Reached(p, 1)) {
      const bool kink = std::any_of(moves.begin(), moves.end(), [&](const Move& m) {
        return m.kind == MoveKind::kR1 && (m.segments[0] == 1 || m.segments[0] == p.segments());
      });
      const bool cross = Has(moves, MoveKind::kCross);
      at_end += kink ? 1 : 0;
      at_end_without_cross += kink && !cross ? 1 : 0;
      if (!cross || !Has(moves, MoveKind::kR1)) continue;
      ++both;
      if (kink) continue;
      ++both_inside;
      least.Offer(p, q, moves);
    }
  });
  Outcome outcome;
  outcome.bound = AllPData(BoundsOf(effort).smaller) + " before the move";
  outcome.numbers = {{"pairs with an R1 at an end segment", at_end},
                     {"of these without a Cross", at_end_without_cross},
                     {"pairs that R1 and Cross explain", both},
                     {"of these without an R1 at an end segment", both_inside}};
  outcome.evidence =
      "An R1 at the first or last segment is a Cross of that end over or under its own segment: the loop "
      "is thrown either way.";
  if (at_end_without_cross + both_inside == 0) {
    outcome.verdict = Verdict::kHoldsTo;
    return outcome;
  }
  outcome.verdict = Verdict::kRefuted;
  if (least.found) {
    outcome.evidence +=
        " But others coincide, too. Smallest: from " + Show(least.before) + " to " + Show(least.after) + ".";
    AddCertificates(outcome, id, least.before, least.more, least.after);
  } else {
    outcome.no_certificate = "the pair was not kept";
  }
  return outcome;
}

Outcome TrySelectiveEnd(Effort effort) {
  const std::string id = "thesis.5.3.5.selective-end";
  long long pairs = 0, resolved = 0, own_before = 0, own_after = 0, undecided = 0;
  std::map<MoveKind, long long> by_kind;
  LeastPair<std::pair<Move, Move>> least;
  ForEachPlanarPDataTo(BoundsOf(effort).smaller, [&](const PData& p) {
    const bool own = EquivalentPData(p) == p;
    const auto reached = Reached(p, 2);
    for (const auto& [q, moves] : reached) {
      ++pairs;
      const PData other = EquivalentPData(q);
      const auto swapped = reached.find(other);
      if (other == q) {
        ++own_after;
      } else if (own) {
        ++own_before;
      } else if (swapped == reached.end()) {
        ++resolved;
      } else {
        ++undecided;
        ++by_kind[moves.front().kind];
        least.Offer(p, q, {moves.front(), swapped->second.front()});
      }
    }
  });
  Outcome outcome;
  outcome.bound = AllPData(BoundsOf(effort).smaller) + " before the move";
  outcome.numbers = {{"pairs that a move explains", pairs},
                     {"resolved: one choice of P(t)'s end is explained", resolved},
                     {"P(t) is its own equivalent", own_after},
                     {"P(t-1) is, P(t) is not", own_before},
                     {"neither is, and both choices are explained", undecided},
                     {"of these by R1 or Cross", by_kind[MoveKind::kR1] + by_kind[MoveKind::kCross]},
                     {"of these by R2", by_kind[MoveKind::kR2]},
                     {"of these by R3", by_kind[MoveKind::kR3]}};
  outcome.verdict = undecided + own_before + own_after == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.evidence =
      "Which end of P(t) is the selective one of P(t-1) comes out unless both choices are explained. That "
      "happens, as the thesis' own third picture does [thesis, 5.4.2], where P(t) is its own equivalent, "
      "which does no harm, and where P(t-1) is, when either end may have moved. It also happens where "
      "neither is";
  if (least.found) {
    outcome.evidence += ". Smallest: from " + Show(least.before) + " moves lead to " + Show(least.after) +
                        " and to its equivalent " + Show(EquivalentPData(least.after)) + ".";
    outcome.certificates = {
        KnotMoveCertificate(id + ".same", id, least.before, least.more.first, least.after),
        KnotMoveCertificate(id + ".swapped", id, least.before, least.more.second,
                            EquivalentPData(least.after))};
  } else {
    outcome.evidence += ", though not to this bound.";
    outcome.no_certificate = "P-data that are their own equivalents are the reason";
  }
  outcome.evidence += "\n\nExplainTransition lists every explanation with its choice of the end.";
  return outcome;
}

// What is read off from the other end, strand by strand: intersections by name, directions turned round.
struct Passage {
  int intersection = 0;
  bool over = false;
  int direction = 1;  // along the rope as it is followed
};

PData ReadFromOtherEnd(const PData& p) {
  const int n = p.columns();
  std::vector<Passage> passages;
  for (int i = n; i >= 1; --i) passages.push_back({std::min(i, p.sigma(i)), p.over(i), -1});
  std::vector<int> sigma(passages.size()), attr(passages.size());
  for (size_t a = 0; a < passages.size(); ++a) {
    for (size_t b = 0; b < passages.size(); ++b) {
      if (a == b || passages[a].intersection != passages[b].intersection) continue;
      sigma[a] = static_cast<int>(b) + 1;
      // (l_over x l_under) . e_z with both directions as they are now followed.
      const int sign = p.sign(passages[a].intersection) * passages[a].direction * passages[b].direction;
      attr[a] = (sign > 0 ? 3 : 1) + (passages[a].over ? 0 : 1);
    }
  }
  return PData(sigma, attr);
}

Outcome TryEquivalent(bool attributes, Effort effort) {
  long long tried = 0, wrong = 0;
  ForEachPlanarPDataTo(BoundsOf(effort).triangle, [&](const PData& p) {
    ++tried;
    const PData q = ReadFromOtherEnd(p);
    const int n = p.columns();
    bool right = true;
    for (int i = 1; i <= n; ++i)
      right =
          right && (attributes ? q.attr(n - i + 1) == p.attr(i) : q.sigma(n - i + 1) == n - p.sigma(i) + 1);
    wrong += right ? 0 : 1;
  });
  Outcome outcome;
  outcome.verdict = wrong == 0 ? Verdict::kProved : Verdict::kRefuted;
  outcome.no_certificate = "one line";
  outcome.bound = "complete; tried on " + AllPData(BoundsOf(effort).triangle);
  outcome.numbers = {{"P-data", tried}, {"wrong", wrong}};
  outcome.evidence =
      attributes ? "Heights stay, and both directions turn round, so their product's sign stays. Planarity "
                   "is not needed."
                 : "The i-th of n passages is the (n - i + 1)-th from the other end, and so is its mate.";
  return outcome;
}

}  // namespace

std::vector<Claim> KnotAmbiguityClaims() {
  return {
      {"thesis.5.2.kinds-overlap",
       "Of the four kinds of movement primitives, R_I and the Cross move and no other two explain one "
       "transition both.",
       "5.2 and 5.4.2", "exhaustive", TryKinds},
      {"thesis.5.3.4.cross-or-r1",
       "R_I and a Cross move explain one transition both just when R_I at the first or last segment does.",
       "5.3.4, with 5.3.1 and 5.4.2", "exhaustive", TryCrossOrR1},
      {"thesis.5.3.5.selective-end",
       "Applying the rules to P_t and to its equivalent P-data tells which end of P_t is the selective one.",
       "5.3.5", "exhaustive", TrySelectiveEnd},
      {"thesis.5.3.5.proposition-14", "sigma(n - i + 1) of the equivalent P-data is n - sigma(i) + 1.",
       "5.3.5, Proposition 14", "symbolic", [](Effort effort) { return TryEquivalent(false, effort); }},
      {"thesis.5.3.5.proposition-15", "attr(n - i + 1) of the equivalent P-data is attr(i).",
       "5.3.5, Proposition 15", "symbolic", [](Effort effort) { return TryEquivalent(true, effort); }}};
}

}  // namespace tact::provers

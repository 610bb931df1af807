// Propositions 10 to 13, Corollaries 1 and 2: how the three segments of an R_III meet, before and after.
#include <map>

#include "algebra/knot/thesis_rules.h"
#include "provers/claims/knot_move_claims.h"
#include "provers/claims/knot_triangle_tally.h"

namespace tact::provers {
namespace {

using knot::PData;
using knot::thesis::PermittedType;
using knot::thesis::TypeOf;

std::string Bound(Effort effort) {
  return "every R3 of " + AllPData(BoundsOf(effort).triangle) + " and of random ropes of 6 to 12";
}

Outcome Hold(Effort effort, long long failures, const std::string& evidence) {
  Outcome outcome;
  outcome.verdict = failures == 0 && TallyTo(effort).moves > 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (outcome.verdict == Verdict::kRefuted) outcome.no_certificate = "the pair was not kept";
  outcome.bound = Bound(effort);
  outcome.numbers = {{"moves", TallyTo(effort).moves}, {"failures", failures}};
  outcome.evidence = evidence;
  return outcome;
}

// All fifteen pairings of the six columns i-1, i, j-1, j, k-1, k, written 0 to 5.
using Pairing = std::array<size_t, 6>;
std::vector<Pairing> SixColumns() {
  std::vector<Pairing> all;
  for (size_t a = 1; a < 6; ++a) {
    std::vector<size_t> rest;
    for (size_t c = 1; c < 6; ++c) {
      if (c != a) rest.push_back(c);
    }
    for (size_t b = 1; b < 4; ++b) {
      Pairing mate{};
      const auto pair = [&](size_t x, size_t y) { mate[x] = y, mate[y] = x; };
      pair(0, a);
      pair(rest[0], rest[b]);
      pair(rest[b == 1 ? 2 : 1], rest[b == 3 ? 2 : 3]);
      all.push_back(mate);
    }
  }
  return all;
}

// The pairing as P-data whose segments A, B, C are 2, 4, 6: columns 1 to 6 are i-1, i, j-1, j, k-1, k.
PData SixColumnPData(const Pairing& mate) {
  std::vector<int> sigma, attr;
  for (size_t c = 0; c < 6; ++c) {
    sigma.push_back(static_cast<int>(mate[c]) + 1);
    attr.push_back(mate[c] > c ? 1 : 2);
  }
  return PData(sigma, attr);
}

Outcome TryProposition10(Effort effort) {
  return Hold(effort, TallyTo(effort).proposition10,
              "Each intersection of the triangle is one of two different segments.");
}

Outcome TryCorollary1(Effort effort) {
  Outcome outcome =
      Hold(effort, TallyTo(effort).corollary1,
           "Of the fifteen pairings of six columns, eight pair no segment with itself, and in all eight "
           "each segment meets both others.");
  long long apart = 0, right = 0;
  const Triangle s = {2, 4, 6};
  for (const Pairing& mate : SixColumns()) {
    const PData p = SixColumnPData(mate);
    bool none_with_itself = true, both_met = true;
    for (const int i : s) {
      none_with_itself = none_with_itself && p.sigma(i) != i - 1;
      both_met = both_met && Partner(p, s, i - 1) != Partner(p, s, i);
    }
    apart += none_with_itself ? 1 : 0;
    right += none_with_itself && both_met ? 1 : 0;
  }
  outcome.numbers.insert(outcome.numbers.end(),
                         {{"pairings with Proposition 10", apart}, {"of these with the corollary", right}});
  if (apart != right) return outcome;
  outcome.verdict = Verdict::kProved;
  outcome.no_certificate = "fifteen cases";
  outcome.bound = "complete; tried on " + Bound(effort);
  return outcome;
}

Outcome TryTypes(Effort effort) {
  const TriangleTally& tally = TallyTo(effort);
  std::map<char, int> pairings;
  long long untyped = 0;
  for (const Pairing& mate : SixColumns()) {
    const PData p = SixColumnPData(mate);
    if (p.sigma(2) == 1 || p.sigma(4) == 3 || p.sigma(6) == 5) continue;
    const auto type = TypeOf(p, {2, 4, 6});
    if (type) {
      ++pairings[*type];
    } else {
      ++untyped;
    }
  }
  bool one_each = pairings.size() == 8 && untyped == 0;
  for (const auto& [type, count] : pairings) one_each = one_each && count == 1;
  Outcome outcome;
  outcome.verdict = one_each && tally.types.size() == 8 ? Verdict::kProved : Verdict::kRefuted;
  outcome.no_certificate = "fifteen cases";
  outcome.bound = "complete; tried on " + Bound(effort);
  outcome.numbers = {{"pairings without a type", untyped},
                     {"types that occur", static_cast<long long>(tally.types.size())},
                     {"faces of three sides", tally.triangles},
                     {"of these with an end segment", tally.at_an_end},
                     {"with an intersection twice", tally.twice},
                     {"with no segment over both others", tally.no_top},
                     {"moves", tally.moves},
                     {"pairs of segments that follow each other", tally.neighbours},
                     {"pairs with one segment between", tally.two_apart}};
  Table table{"Types of the moves before them", {"type", "moves"}, {}};
  for (const auto& [type, count] : tally.types)
    table.rows.push_back({std::string(1, type), std::to_string(count)});
  outcome.tables = {table};
  outcome.evidence =
      "By Proposition 10 and Corollary 1 each of the eight pairings is of just one type, and on a sphere "
      "all eight occur. Two of the three segments never follow each other, since they would share a column.";
  return outcome;
}

Outcome TryProposition11(Effort effort) {
  return Hold(effort, TallyTo(effort).proposition11,
              "More is true: the segments keep their numbers. The move back, read off the faces after it, "
              "has the same i, j and k.");
}

Outcome TryProposition12(Effort effort) {
  return Hold(effort, TallyTo(effort).proposition12,
              "Each segment meets the two others in exchanged order, all three of them.");
}

Outcome TryCorollary2(Effort effort) {
  return Hold(effort, TallyTo(effort).corollary2,
              "By Proposition 12 the i-th intersection after is one with the segment of the (i-1)-th "
              "before, but that segment has exchanged its columns too, so its number is its other one.");
}

Outcome TryProposition13(Effort effort) {
  const TriangleTally& tally = TallyTo(effort);
  long long wrong = 0;
  for (const Pairing& mate : SixColumns()) {
    const PData p = SixColumnPData(mate);
    const auto type = TypeOf(p, {2, 4, 6});
    if (!type) continue;
    // Columns exchanged on every segment [thesis, Proposition 12]: 0 and 1, 2 and 3, 4 and 5.
    Pairing after{};
    for (size_t c = 0; c < 6; ++c) after[c ^ 1] = mate[c] ^ 1;
    const auto to = TypeOf(SixColumnPData(after), {2, 4, 6});
    wrong += to && *to == PermittedType(*type) ? 0 : 1;
  }
  Outcome outcome;
  outcome.verdict = wrong + tally.proposition13 == 0 ? Verdict::kProved : Verdict::kRefuted;
  outcome.no_certificate = "eight cases, given Proposition 12";
  outcome.bound = "complete; tried on " + Bound(effort);
  outcome.numbers = {{"moves", tally.moves},
                     {"failures", tally.proposition13},
                     {"transitions that occur", static_cast<long long>(tally.transitions.size())}};
  Table table{"Transitions that occur", {"before", "after", "moves"}, {}};
  for (const auto& [types, count] : tally.transitions)
    table.rows.push_back({std::string(1, types.first), std::string(1, types.second), std::to_string(count)});
  outcome.tables = {table};
  outcome.evidence =
      "Exchanging the columns of each segment turns each type into the one that the proposition permits; "
      "all four transitions occur, both ways.";
  return outcome;
}

}  // namespace

std::vector<Claim> KnotTriangleClaims() {
  return {
      {"thesis.5.3.3.proposition-10", "sigma(i) is not i - 1, sigma(j) not j - 1, sigma(k) not k - 1.",
       "5.3.3, Proposition 10", "exhaustive", TryProposition10},
      {"thesis.5.3.3.corollary-1", "Of the columns i - 1 and i one meets segment j and the other segment k.",
       "5.3.3, Corollary 1", "exhaustive", TryCorollary1},
      {"thesis.5.3.3.eight-types",
       "The three segments of a Reidemeister move III meet in one of eight types.", "5.3.3", "exhaustive",
       TryTypes},
      {"thesis.5.3.3.proposition-11", "A Reidemeister move III keeps the order of its three segments.",
       "5.3.3, Proposition 11", "exhaustive", TryProposition11},
      {"thesis.5.3.3.proposition-12",
       "A column of segment i that meets segment j before a Reidemeister move III meets segment k after it.",
       "5.3.3, Proposition 12", "exhaustive", TryProposition12},
      {"thesis.5.3.3.corollary-2", "sigma(i-1) before a Reidemeister move III is not sigma(i) after it.",
       "5.3.3, Corollary 2", "exhaustive", TryCorollary2},
      {"thesis.5.3.3.proposition-13",
       "A Reidemeister move III turns type A into H, B into G, C into F, D into E, and back.",
       "5.3.3, Proposition 13", "exhaustive", TryProposition13}};
}

}  // namespace tact::provers

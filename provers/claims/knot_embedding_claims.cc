// Proposition 9: in how many ways a knot graph lies on a sphere.
#include <map>

#include "algebra/knot/reducible.h"
#include "algebra/knot/rotation.h"
#include "algebra/knot/turns.h"
#include "provers/claims/knot_outlines.h"
#include "provers/claims/knot_projection_claims.h"
#include "provers/knot_graph_certificate.h"

namespace tact::provers {
namespace {

using knot::PData;
using knot::Rotation;

// All ways to draw the knot graph on a sphere.
struct Drawings {
  long long all = 0, straight = 0;
  std::optional<Rotation> other;     // neither p's own nor its mirror image
  std::optional<Rotation> nameless;  // not even without names
};
Drawings FindDrawings(const PData& p) {
  Drawings drawings;
  const Rotation own = RotationOf(p), mirror = knot::MirrorRotation(own);
  const std::vector<int> code = knot::NamelessCode(own);
  ForEachPlanarRotation(p, [&](const Rotation& rotation) {
    ++drawings.all;
    drawings.straight += knot::IsStraight(rotation) ? 1 : 0;
    if (rotation == own || rotation == mirror) return;
    if (!drawings.other) drawings.other = rotation;
    if (!drawings.nameless && knot::NamelessCode(rotation) != code) drawings.nameless = rotation;
  });
  return drawings;
}

// "2, 2 and 3": edges of the faces, ascending.
std::string FaceLengths(const Rotation& rotation) {
  std::vector<size_t> lengths;
  for (const auto& face : knot::TraceFaces(rotation)) lengths.push_back(face.size());
  std::sort(lengths.begin(), lengths.end());
  std::string text;
  for (size_t k = 0; k < lengths.size(); ++k)
    text += (k == 0 ? "" : k + 1 == lengths.size() ? " and " : ", ") + std::to_string(lengths[k]);
  return text;
}

Outcome TryProposition9(Effort effort) {
  const std::string id = "thesis.5.1.3.proposition-9";
  Outcome outcome;
  Table table{"Drawings on a sphere of irreducible P-data's knot graphs, mirror images apart",
              {"intersections", "P-data", "more than one drawing", "even without names", "most drawings"},
              {}};
  long long total = 0, total_several = 0, total_unlike = 0;
  std::string named, nameless;
  // Trying all rotations costs six times more for each intersection.
  const int bound = std::min(OutlineBound(effort), 6);
  for (int n = 2; n <= bound; ++n) {
    long long several = 0, unlike = 0, most = 0;
    for (const PData& p : IrreducibleOutlines(n)) {
      const Drawings drawings = FindDrawings(p);
      most = std::max(most, drawings.all / 2);
      several += drawings.other ? 1 : 0;
      unlike += drawings.nameless ? 1 : 0;
      if (drawings.other && named.empty()) {
        named = Show(p);
        outcome.certificates.push_back(
            KnotEmbeddingCertificate(id + ".named", id, p, *drawings.other, false));
      }
      if (drawings.nameless && nameless.empty()) {
        nameless = Show(p) + ": faces of " + FaceLengths(RotationOf(p)) + " edges, or of " +
                   FaceLengths(*drawings.nameless);
        outcome.certificates.push_back(
            KnotEmbeddingCertificate(id + ".nameless", id, p, *drawings.nameless, true));
      }
    }
    const auto number = static_cast<long long>(IrreducibleOutlines(n).size());
    table.rows.push_back(Row({n, number, several, unlike, most}));
    total += number;
    total_several += several;
    total_unlike += unlike;
  }
  if (named.empty() || nameless.empty()) return outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "all irreducible P-data of 2 to " + std::to_string(bound) +
                  " intersections; smallest counterexample: three";
  outcome.tables = {table};
  outcome.numbers = {{"P-data, heights and mirror images apart", total},
                     {"with more than one drawing", total_several},
                     {"even without names", total_unlike}};
  outcome.evidence =
      "The subdivision has one embedding, but it is made from faces: two embeddings of a knot graph give "
      "two subdivisions. Where two vertices part the knot graph, one side can be turned over. Smallest: in " +
      named +
      " two parallel edges may be exchanged. Without names these drawings look alike; the smallest P-data "
      "with drawings that even then differ is " +
      nameless +
      ".\n\n"
      "What such drawings lose is that a strand goes straight on (thesis.5.1.3.proposition-9-corrected).";
  return outcome;
}

Outcome TryProposition9Corrected(Effort effort) {
  // Tracing all rotations where they are few enough, the law of turns elsewhere.
  return Judge(
      TryIrreducible(effort, 2,
                     [](const PData& p) {
                       const auto turned = WithPlanarTurns(p);
                       if (!turned || OutlineOf(*turned) != p) return false;
                       return p.crossings() > 7 || FindDrawings(p).straight == 2;
                     }),
      "All rotations of the knot graph were tried to 7 intersections: of those on a sphere two are "
      "straight, the P-data's own and its mirror image.\n\n"
      "Why it holds for every n: a straight rotation is a choice of turns, left or right, at each "
      "intersection. Let columns i < a < sigma(i) < sigma(a). The rope from i to sigma(i) and that from a "
      "to sigma(a) are closed curves that have a..sigma(i) in common. Pushed apart there they cross once "
      "more just if turn(i) = turn(a), and besides where an intersection has one column on each. On a "
      "sphere they cross an even number of times, so the pairing alone says whether the two turns are "
      "equal. In irreducible P-data such pairs join all intersections: one turn decides all. The law is in "
      "algebra/knot/turns.h; it holds for the random ropes, too.");
}

Outcome TryOneAttribute(Effort effort) {
  // How many choices of turns each pairing has, and how many parts.
  long long pairings = 0, reducible = 0, against = 0;
  std::optional<PData> least;
  for (int n = 1; n <= OutlineBound(effort); ++n) {
    std::map<std::vector<int>, size_t> choices;
    for (const PData& p : Outlines(n)) ++choices[p.SigmaRow()];
    for (const PData& p : Outlines(n)) {
      const auto open = choices.find(p.SigmaRow());
      if (open == choices.end()) continue;  // seen before
      const size_t parts = Split(p).size();
      ++pairings;
      against += open->second == size_t{1} << parts ? 0 : 1;
      reducible += parts > 1 ? 1 : 0;
      if (parts > 1 && !least) least = p;
      choices.erase(open);
    }
  }
  Outcome outcome = Judge(
      TryIrreducible(effort, 1,
                     [](const PData& p) {
                       const auto turned = WithPlanarTurns(p);
                       return turned && OutlineOf(*turned) == p;
                     }),
      "Of irreducible P-data the pairing leaves two choices of turns, mirror images "
      "(thesis.5.1.3.proposition-9-corrected); the height and the sign at one intersection say which. Every "
      "choice of heights is right, so of the others the heights have to be given and the signs follow.\n\n");
  outcome.numbers.push_back({"pairings of a sphere", pairings});
  outcome.numbers.push_back({"reducible ones", reducible});
  outcome.numbers.push_back({"pairings of k parts without 2^k choices of turns", against});
  if (against > 0) outcome.verdict = Verdict::kUndecided;
  if (!least) return outcome;
  outcome.evidence +=
      "Of reducible P-data each part has a choice of its own: a pairing of k parts has 2^k choices of turns "
      "on a sphere, and one attribute does not suffice, first for the pairing of " +
      Show(*least) + ". With one attribute in each part the rest follows.";
  return outcome;
}

}  // namespace

std::vector<Claim> KnotEmbeddingClaims() {
  return {
      {"thesis.5.1.3.proposition-9",
       "An irreducible P-data's knot graph can be embedded in a sphere in one way and its reverse only.",
       "5.1.3, Proposition 9", "exhaustive", TryProposition9},
      {"thesis.5.1.3.proposition-9-corrected",
       "With two intersections or more, an irreducible P-data's knot graph can be embedded in a sphere with "
       "strands that go straight on in one way and its reverse only.",
       "5.1.3, Proposition 9", "exhaustive", TryProposition9Corrected},
      {"thesis.5.1.3.one-attribute",
       "The ambiguity of the reverse is resolved by an attribute of an intersection.", "5.1.3", "exhaustive",
       TryOneAttribute}};
}

}  // namespace tact::provers

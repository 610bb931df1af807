// Definition 6: what reducible P-data consist of, and what it takes to put projections together.
#include <functional>

#include "algebra/knot/closure.h"
#include "algebra/knot/reducible.h"
#include "provers/claims/knot_outlines.h"
#include "provers/claims/knot_projection_claims.h"
#include "provers/knot_graph_certificate.h"

namespace tact::provers {
namespace {

using knot::Part;
using knot::PData;

// Every pairing of so many columns with every choice of turns (or, all strands first over, with one), planar or not.
void ForEachArray(int crossings, bool all_turns, const std::function<void(const PData&)>& visit) {
  std::vector<int> sigma(2 * static_cast<size_t>(crossings), 0), attr = sigma;
  const std::function<void(size_t)> place = [&](size_t from) {
    while (from < sigma.size() && sigma[from] != 0) ++from;
    if (from == sigma.size()) return visit(PData(sigma, attr));
    for (size_t mate = from + 1; mate < sigma.size(); ++mate) {
      if (sigma[mate] != 0) continue;
      sigma[from] = static_cast<int>(mate) + 1;
      sigma[mate] = static_cast<int>(from) + 1;
      for (int a = 1; a <= (all_turns ? 2 : 1); ++a) {
        attr[from] = a;
        attr[mate] = knot::MateAttribute(a);
        place(from + 1);
      }
      sigma[from] = sigma[mate] = 0;
    }
  };
  place(0);
}

bool SidesAreOneFace(const PData& p, int segment) {
  const knot::Faces faces(p);
  return faces.left_of({segment, true}) == faces.left_of({segment, false});
}
// Whether putting x into the segment takes a handle beyond those of both.
bool TakesHandle(const PData& y, int segment, const PData& x) {
  return !EndsOnOneFace(x) && !SidesAreOneFace(y, segment);
}

bool PartsArePlanar(const std::vector<Part>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const Part& part) { return IsPlanar(part.p); });
}

Outcome TryParts(Effort effort) {
  const int bound = OutlineBound(effort);
  long long arrays = 0, reducible = 0, failures = 0;
  for (int n = 0; n <= bound; ++n) {
    ForEachArray(n, false, [&](const PData& p) {
      ++arrays;
      const auto parts = Split(p);
      const bool is_reducible = !ClosedIntervals(p).empty();
      reducible += is_reducible ? 1 : 0;
      bool right = Join(parts) == p && is_reducible == (parts.size() > 1);
      for (const Part& part : parts) right = right && ClosedIntervals(part.p).empty();
      failures += right ? 0 : 1;
    });
  }
  Outcome outcome;
  outcome.verdict = failures == 0 ? Verdict::kHoldsTo : Verdict::kUndecided;
  outcome.bound = "all pairings of up to " + std::to_string(2 * bound) + " columns, of a sphere or not";
  outcome.numbers = {{"pairings", arrays}, {"reducible", reducible}, {"failures", failures}};
  outcome.evidence =
      "The parts are the classes of intersections that alternate along the rope, one with the next. Two "
      "classes do not alternate, so they nest or follow each other: among several one has columns in a row, "
      "and those are closed. Columns that are closed are a union of classes. So P-data are irreducible just "
      "if there is one class, the parts are the only ones, and each is put into a segment of what the "
      "earlier ones make.";
  return outcome;
}

Outcome TryConnecting(Effort effort) {
  const std::string id = "thesis.5.1.3.connecting";
  const int bound = std::min(OutlineBound(effort), 6);
  Outcome outcome;
  Table table{
      "Arrays, heights apart", {"intersections", "whose parts are of a sphere", "of these on no sphere"}, {}};
  long long total = 0, wrong = 0;
  std::optional<PData> least;
  for (int n = 1; n <= bound; ++n) {
    long long with_planar_parts = 0, not_planar = 0;
    ForEachArray(n, true, [&](const PData& p) {
      if (!PartsArePlanar(Split(p))) return;
      ++with_planar_parts;
      if (IsPlanar(p)) return;
      ++not_planar;
      if (!least || p < *least) least = p;
    });
    table.rows.push_back(Row({n, with_planar_parts, not_planar}));
    total += with_planar_parts;
    wrong += not_planar;
  }
  if (!least) return outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "all arrays of up to " + std::to_string(bound) +
                  " intersections, heights apart; smallest counterexample: three";
  outcome.tables = {table};
  outcome.numbers = {{"arrays whose parts are of a sphere", total}, {"of these on no sphere", wrong}};
  outcome.certificates = {KnotPartsCertificate(id + ".counterexample", id, *least)};
  outcome.evidence =
      Show(*least) + " is a loop into which a rope of two intersections is put: " +
      "both are of a sphere, but the rope's two ends lie on two of its faces, so that it leads from one "
      "side of itself to the other, and the loop's segment has two different faces at its sides. It takes a "
      "torus.\n\n"
      "Nor is connecting a matter of putting projections end to end: in (4 3 2 1; 1 1 2 2) a kink is inside "
      "a kink.\n\n"
      "P-data that were read off a rope never fail so (thesis.5.1.3.connecting-corrected); arrays may.";
  return outcome;
}

Outcome TryConnectingCorrected(Effort effort) {
  const int bound = std::min(OutlineBound(effort), 6);
  long long arrays = 0, planar = 0, insertions = 0, failures = 0;
  const auto handles = [](const std::vector<Part>& parts) {
    int count = 0;
    PData joined;
    for (const Part& part : parts) {
      count += TakesHandle(joined, part.segment, part.p) ? 1 : 0;
      joined = Insert(joined, part.segment, part.p);
    }
    return count;
  };
  for (int n = 0; n <= bound; ++n) {
    ForEachArray(n, true, [&](const PData& p) {
      const auto parts = Split(p);
      if (!PartsArePlanar(parts)) {
        failures += IsPlanar(p) ? 1 : 0;
        return;
      }
      ++arrays;
      planar += IsPlanar(p) ? 1 : 0;
      failures += Genus(p) == handles(parts) ? 0 : 1;
    });
  }
  PData last;
  ForEachRandomRope(effort, [&](const PData& rope) {
    failures += handles(Split(rope)) == 0 ? 0 : 1;
    for (int segment = 1; segment <= rope.segments(); ++segment) {
      ++insertions;
      failures += Genus(Insert(rope, segment, last)) == (TakesHandle(rope, segment, last) ? 1 : 0) ? 0 : 1;
    }
    last = rope;
  });
  Outcome outcome;
  outcome.verdict = failures == 0 ? Verdict::kHoldsTo : Verdict::kUndecided;
  outcome.bound = "all arrays of up to " + std::to_string(bound) +
                  " intersections, heights apart; random ropes of 6 to 12 put into each other";
  outcome.numbers = {{"arrays with parts of a sphere", arrays},
                     {"of these of a sphere", planar},
                     {"random insertions", insertions},
                     {"failures", failures}};
  outcome.evidence =
      "If the part's ends lie on one face, that face is made the external one and the part is drawn small "
      "upon the segment. If the segment has one face at both sides, cutting it leaves two pieces that are "
      "drawn small at the two ends of the part. If neither is so, the part joins the two faces at its ends "
      "by the two pieces of the other rope, and these go round the segment: one handle, and each insertion "
      "adds its own. An array is of a sphere just if its parts are and none of the insertions takes a "
      "handle.";
  return outcome;
}

}  // namespace

std::vector<Claim> KnotPartClaims() {
  return {{"thesis.5.1.3.parts", "Reducible P-data consist of irreducible P-data.", "5.1.3, Definition 6",
           "exhaustive", TryParts},
          {"thesis.5.1.3.connecting",
           "All P-data are reversed by connecting the projections of their irreducible parts.", "5.1.3",
           "exhaustive", TryConnecting},
          {"thesis.5.1.3.connecting-corrected",
           "Projections can be connected, one put into a segment of the other, just if the one's ends lie on "
           "one face or the segment has one face at both sides.",
           "5.1.3", "exhaustive", TryConnectingCorrected}};
}

}  // namespace tact::provers

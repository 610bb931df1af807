// The P-data printed in 5.1.2 and 5.4.1, and what the text says of them.
#include <set>

#include "algebra/knot/graph.h"
#include "algebra/knot/reducible.h"
#include "algebra/knot/thesis_face_search.h"
#include "algebra/knot/thesis_graphs.h"
#include "provers/claims/knot_outlines.h"
#include "provers/claims/knot_projection_claims.h"

namespace tact::provers {
namespace {

using knot::PData;
using knot::thesis::Caution;
using knot::thesis::EdgeSet;

PData Figure52() { return PData({4, 5, 6, 1, 2, 3}, {3, 1, 2, 4, 2, 1}); }
PData Overhand() { return PData({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4}); }

Outcome Reproduced(bool right, const std::string& evidence) {
  Outcome outcome;
  outcome.verdict = right ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound = "complete";
  outcome.evidence = evidence;
  return outcome;
}

Outcome TryFigure52(Effort) {
  const PData p = Figure52();
  return Reproduced(
      p.columns() == 6 && p.sigma(2) == 5 && p.attr(3) == 2 && IsPlanar(p) && IsIrreducible(p) &&
          OutlineOf(p) == OutlineOf(Overhand()),
      Show(p) +
          " is P-data of a sphere and irreducible. It has the outline of the overhand knot of 5.4.1, or its "
          "mirror image, with other heights.");
}

Outcome TryKnotGraph(Effort) {
  const knot::Graph printed{3, {{0, 1}, {1, 2}, {2, 0}, {0, 1}, {1, 2}}};
  return Reproduced(
      IsIrreducible(Overhand()) && KnotGraph(Overhand()) == printed,
      "Vertex for vertex and edge for edge. So e1 is the second segment, the first after the first "
      "intersection.");
}

EdgeSet Edges(std::initializer_list<int> edges) {
  EdgeSet set = 0;
  for (const int k : edges) set |= EdgeSet{1} << (k - 1);
  return set;
}

Outcome TryFaces(Effort) {
  const PData p = Overhand();
  std::vector<EdgeSet> printed = {Edges({1, 4}), Edges({2, 5}), Edges({1, 5, 3}), Edges({4, 2, 3})};
  std::sort(printed.begin(), printed.end());
  bool right = knot::thesis::FaceSets(p) == printed;
  for (const Caution caution : {Caution::kNone, Caution::kEdges}) {
    const auto found = knot::thesis::SearchFaces(p, {caution, knot::thesis::LoopOrder::kShortestFirst});
    right = right && found.right && found.wrong == (caution == Caution::kNone);
  }
  for (const EdgeSet loop : {Edges({1, 2, 3}), Edges({3, 4, 5})})
    right = right && knot::thesis::Allows(p, Caution::kNone, loop) &&
            !knot::thesis::Allows(p, Caution::kEdges, loop);
  return Reproduced(right,
                    "The search with the caution finds just the four faces, whatever it chooses; without it "
                    "{e1, e2, e3} or {e3, e4, e5} may be chosen instead, as the text says. e2, e3 and e3, "
                    "e4 follow each other, too, but at vertices of three edges.");
}

// Faces that look alike when the rope is read from its other end. None if that gives other P-data.
long long DifferentExternalFaces(const PData& p) {
  const knot::Faces faces(p);
  if (EquivalentPData(p) != p) return faces.count();
  std::set<int> seen;
  long long different = 0;
  for (int f = 0; f < faces.count(); ++f) {
    const knot::Dart d = faces.walk(f).front();
    const int twin = faces.left_of({p.segments() + 1 - d.segment, !d.forward});
    if (!seen.contains(twin)) ++different;
    seen.insert(f);
  }
  return different;
}

Outcome TryExternalFaces(Effort effort) {
  Outcome outcome = Reproduced(
      DifferentExternalFaces(Overhand()) == 4,
      "The rope tells its faces apart: a map of the sphere that keeps the rope and its direction keeps "
      "every segment. So c + 1 projections on the plane, c intersections, have the same P-data, four of "
      "them the overhand knot's; on the sphere they are one. Where reading from the other end gives the "
      "same P-data, faces that this exchanges look alike.\n\n"
      "So P-data are reversible on the sphere, and on the plane when the external face is given. A rope on "
      "a table moves as on the plane: an R1 or Cross move on the sphere may lead round the back.");
  Table table{"Projections with one P-data but for the choice of the selective end",
              {"intersections", "P-data", "projections on the plane"},
              {}};
  const int bound = std::min(OutlineBound(effort), 5);
  for (int n = 1; n <= bound; ++n) {
    long long p_data = 0, projections = 0;
    ForEachPlanarPData(n, [&](const PData& p) {
      if (CanonicalPData(p) != p) return;
      ++p_data;
      projections += DifferentExternalFaces(p);
    });
    table.rows.push_back(Row({n, p_data, projections}));
  }
  outcome.tables = {table};
  outcome.bound = "complete; counted for " + AllPData(bound);
  return outcome;
}

}  // namespace

std::vector<Claim> KnotExampleClaims() {
  return {
      {"thesis.5.1.3.example", "For the P-data of Figure 5.2, n(P) = 6, sigma(2|P) = 5 and attr(3|P) = 2.",
       "5.1.3, Definitions 3 to 5", "exhaustive", TryFigure52},
      {"thesis.5.4.1.knot-graph",
       "The knot graph of the irreducible P-data (4 5 6 1 2 3; 3 4 3 4 3 4) has three vertices and the five "
       "edges {v1, v2}, {v2, v3}, {v3, v1}, {v1, v2}, {v2, v3}.",
       "5.4.1", "exhaustive", TryKnotGraph},
      {"thesis.5.4.1.faces",
       "Its faces are {e1, e4}, {e2, e5}, {e1, e5, e3} and {e4, e2, e3}, not {e1, e2, e3} and {e3, e4, e5}.",
       "5.4.1", "exhaustive", TryFaces},
      {"thesis.5.4.1.external-faces",
       "Its four faces as external ones give four projections, different on the plane and one on the sphere.",
       "5.4.1", "exhaustive", TryExternalFaces}};
}

}  // namespace tact::provers

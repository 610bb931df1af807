// Knot graphs: what they keep of a rope, Propositions 7 and 8.
#include "algebra/knot/graph.h"
#include "algebra/knot/reducible.h"
#include "algebra/knot/thesis_graphs.h"
#include "provers/claims/knot_outlines.h"
#include "provers/claims/knot_projection_claims.h"
#include "provers/knot_graph_certificate.h"

namespace tact::provers {
namespace {

using knot::PData;

// The first external face with which the dual graph falls apart.
std::optional<int> FindBrokenDual(const PData& p) {
  for (int external = 0; external <= p.crossings(); ++external) {
    if (CountComponents(DualGraph(p, external)) > 1) return external;
  }
  return std::nullopt;
}

// The first external face with which the subdivision is not three-connected.
std::optional<int> FindWeakSubdivision(const PData& p) {
  for (int external = 0; external <= p.crossings(); ++external) {
    if (!IsConnected(BarycentricSubdivision(p, external), 3)) return external;
  }
  return std::nullopt;
}

// How many outlines fail and the least, reducible ones included.
struct AllTrial {
  long long outlines = 0, failures = 0;
  std::optional<PData> first;
};
AllTrial TryReducibleToo(int crossings, std::optional<int> (*find)(const PData&)) {
  AllTrial trial;
  for (int n = 2; n <= crossings; ++n) {
    for (const PData& p : Outlines(n)) {
      ++trial.outlines;
      if (!find(p)) continue;
      ++trial.failures;
      if (!trial.first) trial.first = p;
    }
  }
  return trial;
}
void AddNumbers(Outcome& outcome, const AllTrial& all) {
  outcome.numbers.push_back({"P-data of 2 to 4 intersections, reducible ones included", all.outlines});
  outcome.numbers.push_back({"failures among them", all.failures});
}

Outcome TryGraphAndAttributes(Effort effort) {
  Outcome outcome;
  const int bound = OutlineBound(effort);
  long long outlines = 0, failures = 0;
  for (int n = 1; n <= bound; ++n) {
    for (const PData& p : Outlines(n)) {
      ++outlines;
      // Column k's vertex is where edge e_k begins, the last column's where the last edge ends.
      const knot::Graph graph = KnotGraph(p);
      std::vector<int> first_column(static_cast<size_t>(graph.vertices), 0), sigma, attr;
      for (int k = 1; k <= p.columns(); ++k) {
        const size_t at = static_cast<size_t>(k) - 1;
        const int vertex = k < p.columns() ? graph.edges[at].first : graph.edges[at - 1].second;
        int& first = first_column[static_cast<size_t>(vertex)];
        sigma.push_back(first);
        attr.push_back(first == 0 ? p.attr(k) : knot::MateAttribute(attr[static_cast<size_t>(first) - 1]));
        if (first != 0) sigma[static_cast<size_t>(first) - 1] = k;
        if (first == 0) first = k;
      }
      failures += PData::FindFault(sigma, attr) || PData(sigma, attr) != p ? 1 : 0;
    }
  }
  outcome.verdict = failures == 0 ? Verdict::kHoldsTo : Verdict::kUndecided;
  outcome.bound = AllPData(bound);
  outcome.numbers = {{"P-data, heights apart", outlines}, {"failures", failures}};
  outcome.evidence =
      "The edges with their numbers give the pairing of the columns: e_k leads from column k to column k + "
      "1. One attribute an intersection gives its other one.\n\n"
      "Drawn without the numbers a knot graph does not suffice: an end may leave a vertex of three edges "
      "into each of its three corners. (4 5 6 1 2 3; 1 2 1 2 1 2) and (4 6 5 1 3 2; 1 1 2 2 1 2) have the "
      "same drawing, a triangle with two doubled sides.";
  return outcome;
}

Outcome TryProposition7(Effort effort) {
  Outcome outcome = Judge(TryIrreducible(effort, 0, [](const PData& p) { return !FindBrokenDual(p); }),
                          "Each face was the external one in turn.\n\n"
                          "Why it holds for every n: let a vertex part the knot graph. The rope passes it "
                          "twice, which cuts the rope into three runs, and one side holds just one of them: "
                          "columns in a row with all their mates, so the P-data are reducible. Without such "
                          "a vertex every face is a simple closed path, and the dual graph, too, is parted "
                          "by no vertex, the external face least of all.\n\n");
  const AllTrial all = TryReducibleToo(4, FindBrokenDual);
  AddNumbers(outcome, all);
  if (!all.first) return outcome;
  outcome.evidence += "Read for any P-data it fails, first for " + Show(*all.first) +
                      ": two kinks, their insides joined by nothing but the face outside. The printed proof "
                      "exchanges its second and third case: a rope that stops inside the loop meets what is "
                      "inside after i, so it is the columns from i to n that are closed.";
  return outcome;
}

Outcome TryProposition8(Effort) {
  const std::string id = "thesis.5.1.3.proposition-8";
  // The straight rope has no knot graph.
  const PData kink = IrreducibleOutlines(1).front();
  const auto external = FindWeakSubdivision(kink);
  const AllTrial all = TryReducibleToo(4, FindWeakSubdivision);
  Outcome outcome;
  if (!external || !all.first) return outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "smallest counterexample: one intersection";
  outcome.certificates = {KnotSubdivisionCertificate(id + ".one-intersection", id, kink, *external, {})};
  const auto broken = FindWeakSubdivision(*all.first);
  const auto without = FindSeparator(BarycentricSubdivision(*all.first, *broken), 2);
  if (without) {
    outcome.certificates.push_back(
        KnotSubdivisionCertificate(id + ".reducible", id, *all.first, *broken, *without));
  }
  outcome.numbers = {
      {"vertices of the counterexample's subdivision", BarycentricSubdivision(kink, *external).vertices}};
  AddNumbers(outcome, all);
  outcome.evidence =
      Show(kink) +
      " is irreducible. Its knot graph is a loop, whose subdivision is a triangle with one side doubled: "
      "three vertices, where three-connected asks for four, and nothing that a drawing with straight sides "
      "could keep apart. From two intersections on the proposition holds "
      "(thesis.5.1.3.proposition-8-corrected).\n\n"
      "Reducible P-data fail, too, first " +
      Show(*all.first) + ".";
  return outcome;
}

Outcome TryProposition8Corrected(Effort effort) {
  return Judge(
      TryIrreducible(effort, 2, [](const PData& p) { return !FindWeakSubdivision(p); }),
      "Each face was the external one in turn; each two vertices were taken away.\n\n"
      "Why it holds for every n: no vertex parts the knot graph (thesis.5.1.3.proposition-7), so each face "
      "is a simple closed path, the subdivision of a face with k edges a wheel of 2k spokes, k at least 2, "
      "and two neighbouring wheels share a path of three vertices, of which two may go. The dual graph "
      "joins all of the wheels, and every vertex is on one of them.");
}

}  // namespace

std::vector<Claim> KnotGraphClaims() {
  return {
      {"thesis.5.1.3.knot-graph-and-attributes",
       "A knot graph, its edges numbered, and an attribute of each intersection give the P-data back.",
       "5.1.3, Definition 7", "exhaustive", TryGraphAndAttributes},
      {"thesis.5.1.3.proposition-7",
       "Without the external face the dual of an irreducible P-data's knot graph is connected.",
       "5.1.3, Proposition 7", "exhaustive", TryProposition7},
      {"thesis.5.1.3.proposition-8",
       "The barycentric subdivision of an irreducible P-data's knot graph is three-connected.",
       "5.1.3, Proposition 8", "exhaustive", TryProposition8},
      {"thesis.5.1.3.proposition-8-corrected",
       "With two intersections or more the barycentric subdivision of an irreducible P-data's knot graph is "
       "three-connected.",
       "5.1.3, Proposition 8", "exhaustive", TryProposition8Corrected}};
}

}  // namespace tact::provers

// The search for faces of 5.1.3, read literally in several ways, and corrected.
#include <array>

#include "algebra/knot/reducible.h"
#include "algebra/knot/rotation.h"
#include "algebra/knot/thesis_face_search.h"
#include "algebra/knot/thesis_graphs.h"
#include "algebra/knot/turns.h"
#include "provers/claims/knot_outlines.h"
#include "provers/claims/knot_projection_claims.h"
#include "provers/knot_graph_certificate.h"

namespace tact::provers {
namespace {

using knot::PData;
using namespace knot::thesis;

std::string ShowLoop(EdgeSet set) {
  std::string text;
  for (const int k : EdgesOf(set)) text += (text.empty() ? "{e" : ", e") + std::to_string(k);
  return text + "}";
}

// Whether a face has an edge at both its sides.
bool HasBridge(const PData& p) {
  for (knot::EdgeWalk walk : KnotGraphFaces(p)) {
    std::sort(walk.begin(), walk.end());
    if (std::adjacent_find(walk.begin(), walk.end()) != walk.end()) return true;
  }
  return false;
}

Outcome TryEachEdgeTwice(Effort effort) {
  const auto holds = [](const PData& p) {
    std::vector<int> used(static_cast<size_t>(p.columns()), 0);
    for (const knot::EdgeWalk& walk : KnotGraphFaces(p)) {
      for (const int k : walk) ++used[static_cast<size_t>(k)];
    }
    return !HasBridge(p) && std::count(used.begin(), used.end(), 2) == p.columns() - 1;
  };
  Outcome outcome = Judge(TryIrreducible(effort, 1, holds),
                          "No vertex parts the knot graph (thesis.5.1.3.proposition-7), so neither does an "
                          "edge, and it has two different faces at its sides.");
  const auto& two = Outlines(2);
  const auto first = std::find_if(two.begin(), two.end(), HasBridge);
  if (first == two.end()) return outcome;
  outcome.evidence += "\n\nIn reducible P-data an edge may have one face at both sides, first in " +
                      Show(*first) + ", between two kinks.";
  return outcome;
}

Outcome TryCaution(Effort effort) {
  const auto holds = [](const PData& p, Caution caution) {
    const auto faces = FaceSets(p);
    return std::all_of(faces.begin(), faces.end(), [&](EdgeSet face) { return Allows(p, caution, face); });
  };
  Outcome outcome = Judge(
      TryIrreducible(effort, 2, [&](const PData& p) { return holds(p, Caution::kEdges); }),
      "A face turns at each intersection from one strand to the other, left each time. Where the rope ends, "
      "the segment that the knot graph leaves out stands in the corner between two edges of one strand, and "
      "a face may have both; the text speaks of vertices with four edges, so it is right.\n\n"
      "Its numbers are right if edges are counted as in 5.4.1, where e1 is the second segment. Counted as "
      "in Definition 2, from the selective end, they forbid faces, in 5.4.1 the face {e4, e2, e3}: e3 and "
      "e4 are segments 4 and 5, and the vertex of columns 2 and 5 has four edges. Forbidding two edges in a "
      "row at every vertex would forbid faces from two intersections on. Loops that the caution allows need "
      "not be faces (thesis.5.1.3.face-search).");
  for (const auto& [caution, name] : {std::pair(Caution::kSegments, "counted as in Definition 2"),
                                      std::pair(Caution::kEveryVertex, "at every vertex")}) {
    long long failures = 0;
    for (int n = 2; n <= OutlineBound(effort); ++n) {
      for (const PData& p : IrreducibleOutlines(n)) failures += holds(p, caution) ? 0 : 1;
    }
    outcome.numbers.push_back({"failures, " + std::string(name), failures});
  }
  return outcome;
}

struct NamedReading {
  FaceSearchReading reading;
  const char* name;
};
constexpr std::array<NamedReading, 9> kReadings = {{
    {{Caution::kEdges, LoopOrder::kShortestFirst}, "with the caution, shortest loop first"},
    {{Caution::kEdges, LoopOrder::kEdgeByEdge}, "with the caution, edge by edge"},
    {{Caution::kEdges, LoopOrder::kCornerByCorner}, "with the caution, corner by corner"},
    {{Caution::kNone, LoopOrder::kShortestFirst}, "without the caution, shortest loop first"},
    {{Caution::kNone, LoopOrder::kEdgeByEdge}, "without the caution, edge by edge"},
    {{Caution::kSegments, LoopOrder::kShortestFirst}, "numbers of Definition 2, shortest loop first"},
    {{Caution::kSegments, LoopOrder::kEdgeByEdge}, "numbers of Definition 2, edge by edge"},
    {{Caution::kEveryVertex, LoopOrder::kShortestFirst}, "at every vertex, shortest loop first"},
    {{Caution::kEveryVertex, LoopOrder::kEdgeByEdge}, "at every vertex, edge by edge"},
}};

Outcome TryFaceSearch(Effort effort) {
  const std::string id = "thesis.5.1.3.face-search";
  const int bound = std::max(OutlineBound(effort), 6);
  Outcome outcome;
  Table table{"P-data, heights and mirror images apart, for which the search finds the faces",
              {"reading", "whatever is chosen", "by some choices", "never", "first failure", "first never"},
              {}};
  std::vector<std::string> shown;
  for (size_t k = 0; k < kReadings.size(); ++k) {
    long long always = 0, sometimes = 0, never = 0;
    std::optional<PData> first, first_never;
    for (int n = 2; n <= bound; ++n) {
      for (const PData& p : IrreducibleOutlines(n)) {
        const FaceSearchOutcome found = SearchFaces(p, kReadings[k].reading);
        ++(!found.wrong ? always : found.right ? sometimes : never);
        const std::string name = id + ".reading-" + std::to_string(k + 1);
        if (found.wrong && !first) {
          first = p;
          outcome.certificates.push_back(
              KnotFaceSearchCertificate(name + ".first", id, p, kReadings[k].reading, found));
          if (k == 0) shown = {Show(p), ShowLoop(found.chosen.back())};
        }
        if (found.wrong && !found.right && !first_never) {
          first_never = p;
          if (p == *first) continue;
          outcome.certificates.push_back(
              KnotFaceSearchCertificate(name + ".never", id, p, kReadings[k].reading, found));
        }
      }
    }
    table.rows.push_back({kReadings[k].name, std::to_string(always), std::to_string(sometimes),
                          std::to_string(never), first ? Show(*first) : "none",
                          first_never ? Show(*first_never) : "none"});
    if (k > 2) continue;
    outcome.numbers.push_back({std::string(kReadings[k].name) + ", by some choices", sometimes});
    outcome.numbers.push_back({std::string(kReadings[k].name) + ", never", never});
  }
  if (shown.empty()) return outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "all irreducible P-data of 2 to " + std::to_string(bound) +
                  " intersections; smallest counterexample: five";
  outcome.tables = {table};
  outcome.evidence =
      "Three readings of the search, shortest of all loops first, edge after edge, or corner after corner "
      "of two edges that the caution allows, each with every way to choose among loops of one length, and "
      "three of the caution. With the caution, edges counted as in 5.4.1, all is well up to four "
      "intersections. First failure: in " +
      shown[0] + " the loop " + shown[1] +
      " is as short as faces that are left, turns left at one intersection and right at another, and has "
      "parts of the rope on both sides. From six intersections on there are P-data for which no choices are "
      "right: the loop is shorter than a face.\n\n"
      "Corrected: trace the faces by the turns (thesis.5.1.3.face-search-corrected).";
  return outcome;
}

Outcome TryFaceSearchCorrected(Effort effort) {
  return Judge(
      TryIrreducible(effort, 2,
                     [](const PData& p) {
                       // The pairing alone, as a knot graph has it; mirrored, the sets are the same.
                       const auto turned = WithPlanarTurns(p);
                       if (!turned || FaceSets(*turned) != FaceSets(p)) return false;
                       std::vector<EdgeSet> traced;
                       for (const auto& face : knot::TraceFaces(RotationOf(p))) {
                         EdgeSet set = 0;
                         for (const int dart : face) set |= EdgeSet{1} << (std::abs(dart) - 1);
                         traced.push_back(set);
                       }
                       std::sort(traced.begin(), traced.end());
                       return traced == FaceSets(p) && static_cast<int>(traced.size()) == p.crossings() + 1 &&
                              std::all_of(traced.begin(), traced.end(),
                                          [&](EdgeSet face) { return Allows(p, Caution::kEdges, face); });
                     }),
      "A face goes on, at each intersection, along the other strand to the left. The turns are those of the "
      "attributes or, the reverse apart, of the pairing alone (thesis.5.1.3.proposition-9-corrected), so "
      "that a knot graph suffices. Tracing takes each side of each edge once, in linear time; by Euler's "
      "formula there are as many faces as the sphere asks for, which makes them all. Two tracings, with the "
      "end segments and without, give the same.");
}

}  // namespace

std::vector<Claim> KnotFaceClaims() {
  return {
      {"thesis.5.1.3.each-edge-twice",
       "Each edge of an irreducible P-data's knot graph is a component of two faces.", "5.1.3", "exhaustive",
       TryEachEdgeTwice},
      {"thesis.5.1.3.caution",
       "At a vertex with four edges, no face of an irreducible P-data's knot graph includes two edges that "
       "follow each other along the rope.",
       "5.1.3", "exhaustive", TryCaution},
      {"thesis.5.1.3.face-search",
       "Searching shorter loops of the knot graph, each edge in two and none with two edges of one strand, "
       "extracts all faces.",
       "5.1.3", "exhaustive", TryFaceSearch},
      {"thesis.5.1.3.face-search-corrected",
       "Tracing the knot graph by the turns that the pairing alone gives extracts all faces.", "5.1.3",
       "exhaustive", TryFaceSearchCorrected}};
}

}  // namespace tact::provers

// Certificates about knot graphs, faces and parts: written by the engine, changed, and judged by the engine again.
#include "provers/knot_graph_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "algebra/knot/graph.h"
#include "algebra/knot/reducible.h"
#include "algebra/knot/thesis_graphs.h"
#include "provers/check/check.h"
#include "provers/check/knot_graph.h"
#include "provers/claims/knot_outlines.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::provers {
namespace {

using knot::MirrorRotation;
using knot::NamelessCode;
using knot::PData;
using knot::thesis::Caution;
using knot::thesis::EdgeSet;
using knot::thesis::FaceSearchReading;
using knot::thesis::FaceSets;
using knot::thesis::LoopOrder;
using nlohmann::json;

// By vertices, then by edges, the first two edges that the caution allows together and no chosen loop has; 0: none.
EdgeSet FirstOpenCorner(const PData& p, Caution caution, const std::set<EdgeSet>& chosen) {
  const knot::Graph graph = KnotGraph(p);
  for (int v = 0; v < graph.vertices; ++v) {
    for (size_t a = 0; a < graph.edges.size(); ++a) {
      for (size_t b = a + 1; b < graph.edges.size(); ++b) {
        const auto at = [&](size_t e) { return graph.edges[e].first == v || graph.edges[e].second == v; };
        const EdgeSet corner = EdgeSet{1} << a | EdgeSet{1} << b;
        if (!at(a) || !at(b) || !Allows(p, caution, corner)) continue;
        if (std::none_of(chosen.begin(), chosen.end(), [&](EdgeSet x) { return (x & corner) == corner; }))
          return corner;
      }
    }
  }
  return 0;
}

// Every loop that the rule may choose after faces only, and no face; 0: nothing to choose.
std::set<EdgeSet> WrongChoices(const PData& p, const FaceSearchReading& reading) {
  const auto faces = FaceSets(p), loops = FindLoops(p, reading.caution);
  std::set<EdgeSet> wrong;
  std::set<std::set<EdgeSet>> seen;
  const std::function<void(const std::set<EdgeSet>&)> choose = [&](const std::set<EdgeSet>& chosen) {
    if (!seen.insert(chosen).second) return;
    EdgeSet once = 0, twice = 0;
    for (const EdgeSet face : chosen) twice |= once & face, once |= face;
    if (std::popcount(twice) == p.columns() - 1) return;
    EdgeSet wanted = 0;
    if (reading.order == LoopOrder::kEdgeByEdge) wanted = ~twice & (twice + 1);
    if (reading.order == LoopOrder::kCornerByCorner) wanted = FirstOpenCorner(p, reading.caution, chosen);
    int shortest = 0;
    for (const EdgeSet loop : loops) {
      if ((loop & twice) != 0 || chosen.contains(loop) || (loop & wanted) != wanted) continue;
      if (shortest != 0 && std::popcount(loop) > shortest) break;
      shortest = std::popcount(loop);
      std::set<EdgeSet> more = chosen;
      more.insert(loop);
      if (std::count(faces.begin(), faces.end(), loop) == 0) {
        wrong.insert(loop);
      } else {
        choose(more);
      }
    }
    if (shortest == 0) wrong.insert(0);
  };
  choose({});
  return wrong;
}

std::optional<EdgeSet> SetOf(const json& edges, int count) {
  EdgeSet set = 0;
  int last = 0;
  for (const int k : edges.get<std::vector<int>>()) {
    if (k <= last || k > count) return std::nullopt;
    set |= EdgeSet{1} << (k - 1);
    last = k;
  }
  return set;
}

bool EmbeddingIsRight(const json& c, const PData& p) {
  knot::Rotation rotation = c["rotation"];
  const knot::Rotation own = RotationOf(p);
  if (rotation.size() != own.size()) return false;
  for (size_t v = 0; v < own.size(); ++v) {
    if (!std::is_permutation(rotation[v].begin(), rotation[v].end(), own[v].begin(), own[v].end()))
      return false;
    std::rotate(rotation[v].begin(), std::min_element(rotation[v].begin(), rotation[v].end()),
                rotation[v].end());
  }
  if (knot::Genus(rotation) != 0 || rotation == own || rotation == MirrorRotation(own)) return false;
  return !c["nameless"] || NamelessCode(rotation) != NamelessCode(own);
}

bool FaceSearchIsRight(const json& c, const PData& p) {
  const std::vector<std::string> cautions = {"none", "edges", "segments", "every-vertex"};
  const auto caution = std::find(cautions.begin(), cautions.end(), c["rule"]["caution"]) - cautions.begin();
  if (caution == 4) return false;
  const std::vector<std::string> orders = {"shortest-first", "edge-by-edge", "corner-by-corner"};
  const auto order = std::find(orders.begin(), orders.end(), c["rule"]["order"]) - orders.begin();
  const FaceSearchReading reading{static_cast<Caution>(caution), static_cast<LoopOrder>(order)};
  const auto chosen = SetOf(c["chooses"], p.columns() - 1);
  return chosen && WrongChoices(p, reading).contains(*chosen) &&
         c["always"] == !SearchFaces(p, reading).right;
}

bool PartsAreRight(const json& c, const PData& p) {
  const json classes = json::parse(KnotPartsCertificate("t", "c", p).json)["parts"];
  if (IsPlanar(p) ||
      !std::is_permutation(classes.begin(), classes.end(), c["parts"].begin(), c["parts"].end()))
    return false;
  const auto parts = Split(p);
  return std::all_of(parts.begin(), parts.end(), [](const knot::Part& part) { return IsPlanar(part.p); });
}

bool IsRight(const json& c) {
  if (c["version"] != 1) return false;
  const auto sigma = c["p_data"]["sigma"].get<std::vector<int>>();
  const auto attr = c["p_data"]["attr"].get<std::vector<int>>();
  if (PData::FindFault(sigma, attr)) return false;
  const PData p(sigma, attr);
  if (c["kind"] == "knot-parts") return PartsAreRight(c, p);
  if (!IsPlanar(p) || !IsIrreducible(p) || p.crossings() < 2) return false;
  return c["kind"] == "knot-embedding" ? EmbeddingIsRight(c, p) : FaceSearchIsRight(c, p);
}

void ExpectJudged(const json& c, int& right, int& wrong) {
  const bool expected = IsRight(c);
  const auto answer = check::CheckCertificate(c.dump());
  EXPECT_EQ(answer.accepted, expected) << answer.why << c.dump();
  ++(expected ? right : wrong);
}

// Each number in turn replaced by others.
void ExpectChangesJudged(const json& original, int& right, int& wrong) {
  ASSERT_TRUE(check::CheckCertificate(original.dump()).accepted) << original.dump();
  const json flat = original.flatten();
  for (const auto& [path, value] : flat.items()) {
    json mutant = original;
    json& place = mutant.at(json::json_pointer(path));
    if (value.is_boolean()) {
      place = !value.get<bool>();
      ExpectJudged(mutant, right, wrong);
    }
    if (!value.is_number_integer()) continue;
    const int number = value;
    for (const int changed : {number - 1, number + 1, number ^ 2, -number, 0, 9}) {
      place = changed;
      ExpectJudged(mutant, right, wrong);
    }
  }
}

TEST(KnotGraphCertificate, EveryOtherPlanarRotationIsAcceptedAndItsChangesAreJudged) {
  int right = 0, wrong = 0, accepted = 0;
  for (int n = 3; n <= 5; ++n) {
    for (const PData& p : IrreducibleOutlines(n)) {
      const knot::Rotation own = RotationOf(p), mirror = MirrorRotation(own);
      ForEachPlanarRotation(p, [&](const knot::Rotation& rotation) {
        const bool nameless = NamelessCode(rotation) != NamelessCode(own);
        const json c = json::parse(KnotEmbeddingCertificate("t", "c", p, rotation, nameless).json);
        ExpectJudged(c, right, wrong);
        EXPECT_EQ(check::CheckCertificate(c.dump()).accepted, rotation != own && rotation != mirror);
        if (rotation != own && rotation != mirror && ++accepted % 40 == 0)
          ExpectChangesJudged(c, right, wrong);
      });
    }
  }
  EXPECT_GT(accepted, 300);
  EXPECT_GT(wrong, 1000);
}

TEST(KnotGraphCertificate, EveryFailingSearchIsAcceptedAndItsChangesAreJudged) {
  int right = 0, wrong = 0, number = 0;
  for (int n = 2; n <= 5; ++n) {
    for (const PData& p : IrreducibleOutlines(n)) {
      for (const Caution caution :
           {Caution::kNone, Caution::kEdges, Caution::kSegments, Caution::kEveryVertex}) {
        for (const LoopOrder order :
             {LoopOrder::kShortestFirst, LoopOrder::kEdgeByEdge, LoopOrder::kCornerByCorner}) {
          const FaceSearchReading reading{caution, order};
          const auto outcome = SearchFaces(p, reading);
          if (!outcome.wrong) continue;
          const json c = json::parse(KnotFaceSearchCertificate("t", "c", p, reading, outcome).json);
          EXPECT_TRUE(check::CheckCertificate(c.dump()).accepted) << c.dump();
          if (++number % 37 == 0) ExpectChangesJudged(c, right, wrong);
        }
      }
    }
  }
  EXPECT_GT(number, 200);
  EXPECT_GT(right, 10);
  EXPECT_GT(wrong, 500);
}

TEST(KnotGraphCertificate, PartsOfEveryArrayOfThreeIntersectionsAreJudged) {
  int right = 0, wrong = 0;
  knot::ForEachPData(3, [&](const PData& p) {
    const json c = json::parse(KnotPartsCertificate("t", "c", p).json);
    ExpectJudged(c, right, wrong);
    if (IsRight(c) && right % 8 == 0) ExpectChangesJudged(c, right, wrong);
  });
  EXPECT_GE(right, 32);
  EXPECT_GT(wrong, 500);
}

// Twin: whether two vertices part the subdivision, by both graphs.
TEST(KnotGraphCertificate, EveryPairOfVerticesOfASubdivisionIsJudged) {
  int right = 0, wrong = 0;
  for (const PData& p : Outlines(3)) {
    for (int external = 0; external <= 3; external += 3) {
      const knot::Graph graph = BarycentricSubdivision(p, external);
      for (int a = 0; a < graph.vertices; ++a) {
        for (int b = a + 1; b < graph.vertices; ++b) {
          const bool parted = CountComponents(graph, {a, b}) > 1;
          const auto certificate = KnotSubdivisionCertificate("t", "c", p, external, {a, b});
          EXPECT_EQ(check::CheckCertificate(certificate.json).accepted, parted) << certificate.json;
          ++(parted ? right : wrong);
        }
      }
    }
  }
  EXPECT_GT(right, 100);
  EXPECT_GT(wrong, 1000);
}

// Twin: the checker's graph, faces and Definition 6 against the engine's.
TEST(KnotGraphTwin, GraphFacesAndDefinitionSixAreTheSameForAllArraysToThreeIntersections) {
  for (int c = 1; c <= 3; ++c) {
    knot::ForEachPData(c, [](const PData& p) {
      const check::KnotCode code{p.SigmaRow(), p.AttrRow()};
      EXPECT_EQ(check::IsIrreducible(code), IsIrreducible(p)) << p.ToJson();
      EXPECT_EQ(check::GraphOf(code).edges, KnotGraph(p).edges);
      std::multiset<std::vector<int>> faces;
      for (knot::EdgeWalk walk : KnotGraphFaces(p)) {
        std::sort(walk.begin(), walk.end());
        faces.insert(walk);
      }
      const auto checked = check::FaceEdges(code);
      EXPECT_EQ(std::multiset<std::vector<int>>(checked.begin(), checked.end()), faces) << p.ToJson();
    });
  }
}

}  // namespace
}  // namespace tact::provers

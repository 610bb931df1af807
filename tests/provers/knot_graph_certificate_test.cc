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
#include "tests/provers/knot_graph_oracle.h"

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

void ExpectJudged(const json& c, int& right, int& wrong) {
  const bool expected = oracle::KnotGraphIsRight(c);
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
    if (oracle::KnotGraphIsRight(c) && right % 8 == 0) ExpectChangesJudged(c, right, wrong);
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

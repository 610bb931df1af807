/// @file
/// Whether a certificate about knot graphs, faces and parts is right, decided by algebra/knot.
#pragma once

#include <algorithm>
#include <bit>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "algebra/knot/faces.h"
#include "algebra/knot/graph.h"
#include "algebra/knot/reducible.h"
#include "algebra/knot/rotation.h"
#include "algebra/knot/thesis_face_search.h"
#include "algebra/knot/thesis_graphs.h"
#include "provers/knot_graph_certificate.h"

namespace tact::provers::oracle {

using knot::thesis::Caution;
using knot::thesis::EdgeSet;
using knot::thesis::FaceSearchReading;
using knot::thesis::LoopOrder;

// By vertices, then by edges, the first two edges that the caution allows together and no chosen loop has; 0: none.
inline EdgeSet FirstOpenCorner(const knot::PData& p, Caution caution, const std::set<EdgeSet>& chosen) {
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
inline std::set<EdgeSet> WrongChoices(const knot::PData& p, const FaceSearchReading& reading) {
  const auto faces = knot::thesis::FaceSets(p), loops = knot::thesis::FindLoops(p, reading.caution);
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

inline std::optional<EdgeSet> SetOf(const nlohmann::json& edges, int count) {
  EdgeSet set = 0;
  int last = 0;
  for (const int k : edges.get<std::vector<int>>()) {
    if (k <= last || k > count) return std::nullopt;
    set |= EdgeSet{1} << (k - 1);
    last = k;
  }
  return set;
}

inline bool EmbeddingIsRight(const nlohmann::json& c, const knot::PData& p) {
  knot::Rotation rotation = c["rotation"];
  const knot::Rotation own = RotationOf(p);
  if (rotation.size() != own.size()) return false;
  for (size_t v = 0; v < own.size(); ++v) {
    if (!std::is_permutation(rotation[v].begin(), rotation[v].end(), own[v].begin(), own[v].end()))
      return false;
    std::rotate(rotation[v].begin(), std::min_element(rotation[v].begin(), rotation[v].end()),
                rotation[v].end());
  }
  if (knot::Genus(rotation) != 0 || rotation == own || rotation == knot::MirrorRotation(own)) return false;
  return !c["nameless"] || knot::NamelessCode(rotation) != knot::NamelessCode(own);
}

inline bool FaceSearchIsRight(const nlohmann::json& c, const knot::PData& p) {
  const std::vector<std::string> cautions = {"none", "edges", "segments", "every-vertex"};
  const auto caution = std::find(cautions.begin(), cautions.end(), c["rule"]["caution"]) - cautions.begin();
  if (caution == 4) return false;
  const std::vector<std::string> orders = {"shortest-first", "edge-by-edge", "corner-by-corner"};
  const auto order = std::find(orders.begin(), orders.end(), c["rule"]["order"]) - orders.begin();
  const FaceSearchReading reading{static_cast<Caution>(caution), static_cast<LoopOrder>(order)};
  const auto chosen = SetOf(c["chooses"], p.columns() - 1);
  return chosen && WrongChoices(p, reading).contains(*chosen) &&
         c["always"] == !knot::thesis::SearchFaces(p, reading).right;
}

inline bool PartsAreRight(const nlohmann::json& c, const knot::PData& p) {
  const nlohmann::json classes = nlohmann::json::parse(KnotPartsCertificate("t", "c", p).json)["parts"];
  if (IsPlanar(p) ||
      !std::is_permutation(classes.begin(), classes.end(), c["parts"].begin(), c["parts"].end()))
    return false;
  const auto parts = Split(p);
  return std::all_of(parts.begin(), parts.end(), [](const knot::Part& part) { return IsPlanar(part.p); });
}

inline bool SubdivisionIsRight(const nlohmann::json& c, const knot::PData& p) {
  if (!IsPlanar(p) || p.columns() == 0) return false;
  std::vector<knot::EdgeWalk> own = KnotGraphFaces(p);
  for (knot::EdgeWalk& face : own) std::sort(face.begin(), face.end());
  const auto listed = c["faces"].get<std::vector<knot::EdgeWalk>>();
  if (!std::is_permutation(own.begin(), own.end(), listed.begin(), listed.end())) return false;
  // Faces of the same edges are the same to the graph: each is taken once.
  std::vector<int> number;
  for (const knot::EdgeWalk& face : listed) {
    for (size_t k = 0; k < own.size(); ++k) {
      if (own[k] != face || std::count(number.begin(), number.end(), static_cast<int>(k)) != 0) continue;
      number.push_back(static_cast<int>(k));
      break;
    }
  }
  const int external = number.front(), first_face = p.crossings() + p.columns() - 1;
  const knot::Graph graph = BarycentricSubdivision(p, external);
  std::vector<int> without = c["without"];
  if (without.size() > 2) return false;
  for (int& v : without) {
    if (v < 0 || v >= graph.vertices) return false;
    if (v < first_face) continue;
    const int face = number[static_cast<size_t>(v - first_face) + 1];
    v = first_face + face - (face > external ? 1 : 0);
  }
  return graph.vertices <= 3 || CountComponents(graph, without) > 1;
}

inline bool KnotGraphIsRight(const nlohmann::json& c) {
  if (c["version"] != 1) return false;
  const auto sigma = c["p_data"]["sigma"].get<std::vector<int>>();
  const auto attr = c["p_data"]["attr"].get<std::vector<int>>();
  if (knot::PData::FindFault(sigma, attr)) return false;
  const knot::PData p(sigma, attr);
  if (c["kind"] == "knot-parts") return PartsAreRight(c, p);
  if (c["kind"] == "knot-subdivision") return SubdivisionIsRight(c, p);
  if (!IsPlanar(p) || !IsIrreducible(p) || p.crossings() < 2) return false;
  return c["kind"] == "knot-embedding" ? EmbeddingIsRight(c, p) : FaceSearchIsRight(c, p);
}

}  // namespace tact::provers::oracle

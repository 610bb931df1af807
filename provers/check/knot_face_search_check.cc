// `knot-face-search`: P-data on which the search for faces of [thesis, 5.1.3] goes wrong, for some or for all of its
// choices. Every choice is tried.
#include <algorithm>
#include <set>
#include <string>

#include "provers/check/kinds.h"
#include "provers/check/knot_graph.h"

namespace tact::check {
namespace {

constexpr int kMostColumns = 18;
using Loop = std::vector<int>;  // edges, ascending

struct Rule {
  std::string caution, order;
};

Rule ReadRule(const Value& value) {
  ExpectKeys(value, {"caution", "order"});
  Rule rule;
  rule.caution = AsString(At(value, "caution"));
  rule.order = AsString(At(value, "order"));
  const std::set<std::string> cautions = {"none", "edges", "segments", "every-vertex"},
                              orders = {"shortest-first", "edge-by-edge", "corner-by-corner"};
  if (!cautions.contains(rule.caution)) throw Refused(&At(value, "caution"), "no reading has this name");
  if (!orders.contains(rule.order)) throw Refused(&At(value, "order"), "no reading has this name");
  return rule;
}

bool Has(const Loop& loop, int edge) { return std::binary_search(loop.begin(), loop.end(), edge); }

bool Includes(const Loop& loop, const Loop& part) {
  return std::includes(loop.begin(), loop.end(), part.begin(), part.end());
}

bool IsAllowed(const KnotCode& code, const Rule& rule, const Loop& loop) {
  for (int i = 2; i < code.columns() && rule.caution != "none"; ++i) {
    const bool four = code.mate(i) != 1 && code.mate(i) != code.columns();
    if (!four && rule.caution != "every-vertex") continue;
    const int later = rule.caution == "segments" ? i - 1 : i;
    if (Has(loop, later - 1) && Has(loop, later)) return false;
  }
  return true;
}

// Every set of edges that meets each vertex twice or never and hangs together, if the caution allows it.
std::vector<Loop> AllLoops(const KnotCode& code, const Rule& rule) {
  const KnotGraph graph = GraphOf(code);
  std::vector<Loop> loops;
  for (unsigned set = 1; set < 1u << graph.edges.size(); ++set) {
    Loop loop;
    std::vector<std::pair<int, int>> edges;
    std::vector<int> met(static_cast<std::size_t>(graph.vertices), 0);
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      if ((set >> e & 1) == 0) continue;
      loop.push_back(static_cast<int>(e) + 1);
      edges.push_back(graph.edges[e]);
      ++met[static_cast<std::size_t>(graph.edges[e].first)];
      ++met[static_cast<std::size_t>(graph.edges[e].second)];
    }
    const auto never = std::count(met.begin(), met.end(), 0), twice = std::count(met.begin(), met.end(), 2);
    if (never + twice == graph.vertices && CountPieces(graph.vertices, edges, {}) == never + 1 &&
        IsAllowed(code, rule, loop))
      loops.push_back(loop);
  }
  return loops;
}

// Each two edges of a vertex that the caution allows together, by vertices, then by edges.
std::vector<Loop> AllCorners(const KnotCode& code, const Rule& rule) {
  const KnotGraph graph = GraphOf(code);
  const auto at = [&](int edge, int v) {
    const auto& [a, b] = graph.edges[static_cast<std::size_t>(edge) - 1];
    return a == v || b == v;
  };
  std::vector<Loop> corners;
  for (int v = 0; v < graph.vertices; ++v) {
    for (int a = 1; a < code.columns(); ++a) {
      for (int b = a + 1; b < code.columns(); ++b) {
        if (at(a, v) && at(b, v) && IsAllowed(code, rule, {a, b})) corners.push_back({a, b});
      }
    }
  }
  return corners;
}

class Search {
 public:
  Search(const KnotCode& code, const Rule& rule)
      : edges_(code.columns() - 1),
        rule_(rule),
        loops_(AllLoops(code, rule)),
        corners_(AllCorners(code, rule)) {
    for (const Loop& face : FaceEdges(code)) faces_.insert(face);
    Choose({});
  }
  bool right() const { return right_; }
  // The loops that are no faces and may be chosen after faces only; the empty one if there may be none to choose.
  const std::set<Loop>& wrong() const { return wrong_; }

 private:
  void Choose(const std::set<Loop>& chosen) {
    if (!visited_.insert(chosen).second) return;
    const auto uses = [&](int edge) {
      return std::count_if(chosen.begin(), chosen.end(), [&](const Loop& loop) { return Has(loop, edge); });
    };
    int first = 1;
    while (first <= edges_ && uses(first) == 2) ++first;
    if (first > edges_) {
      right_ = true;
      return;
    }
    Loop wanted;  // edges that the next loop includes
    if (rule_.order == "edge-by-edge") wanted = {first};
    if (rule_.order == "corner-by-corner") {
      for (const Loop& corner : corners_) {
        if (std::any_of(chosen.begin(), chosen.end(),
                        [&](const Loop& loop) { return Includes(loop, corner); }))
          continue;
        wanted = corner;
        break;
      }
    }
    std::vector<Loop> next;
    for (const Loop& loop : loops_) {
      if (chosen.contains(loop) || !Includes(loop, wanted)) continue;
      if (std::any_of(loop.begin(), loop.end(), [&](int edge) { return uses(edge) == 2; })) continue;
      if (!next.empty() && loop.size() > next.front().size()) continue;
      if (!next.empty() && loop.size() < next.front().size()) next.clear();
      next.push_back(loop);
    }
    if (next.empty()) wrong_.insert(Loop{});
    for (const Loop& loop : next) {
      if (!faces_.contains(loop)) {
        wrong_.insert(loop);
        continue;
      }
      std::set<Loop> more = chosen;
      more.insert(loop);
      Choose(more);
    }
  }

  int edges_;
  Rule rule_;
  std::vector<Loop> loops_, corners_;
  std::set<Loop> faces_, wrong_;
  std::set<std::set<Loop>> visited_;
  bool right_ = false;
};

}  // namespace

void CheckKnotFaceSearch(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "rule", "chooses", "always"});
  const KnotCode code = ReadIrreducibleCode(certificate, 2);
  if (code.columns() > kMostColumns)
    throw Refused(&At(certificate, "p_data"),
                  "this checker tries up to " + std::to_string(kMostColumns / 2) + " intersections");
  const Value& chooses = At(certificate, "chooses");
  const Search search(code, ReadRule(At(certificate, "rule")));
  if (!search.wrong().contains(ReadEdges(chooses, code)))
    throw Refused(&chooses, "the rule never chooses this after faces only, or it is a face");
  if (AsBool(At(certificate, "always")) != !search.right())
    throw Refused(&At(certificate, "always"), "whether some choices give all faces is not as said");
}

}  // namespace tact::check

#include "algebra/knot/thesis_face_search.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <set>

#include "algebra/error.h"
#include "algebra/knot/thesis_graphs.h"

namespace tact::knot::thesis {
namespace {

EdgeSet Bit(int edge) { return EdgeSet{1} << (edge - 1); }

// Simple closed paths from the least vertex on; each is found in both directions and kept once.
std::vector<EdgeSet> SimpleLoops(const Graph& graph) {
  std::set<EdgeSet> loops;
  std::vector<bool> on_path(static_cast<size_t>(graph.vertices));
  const std::function<void(int, int, EdgeSet)> extend = [&](int start, int at, EdgeSet used) {
    for (size_t e = 0; e < graph.edges.size(); ++e) {
      const EdgeSet edge = EdgeSet{1} << e;
      const auto [a, b] = graph.edges[e];
      if ((used & edge) != 0 || (a != at && b != at)) continue;
      const int to = a == at ? b : a;
      if (to == start) loops.insert(used | edge);
      if (to <= start || on_path[static_cast<size_t>(to)]) continue;
      on_path[static_cast<size_t>(to)] = true;
      extend(start, to, used | edge);
      on_path[static_cast<size_t>(to)] = false;
    }
  };
  for (int start = 0; start < graph.vertices; ++start) extend(start, start, 0);
  return {loops.begin(), loops.end()};
}

// Two edges of one vertex that the caution allows together, by vertices, then by edges.
std::vector<EdgeSet> Corners(const PData& p, Caution caution) {
  const Graph graph = KnotGraph(p);
  std::vector<EdgeSet> corners;
  for (int v = 0; v < graph.vertices; ++v) {
    std::vector<EdgeSet> edges;
    for (size_t e = 0; e < graph.edges.size(); ++e) {
      if (graph.edges[e].first == v || graph.edges[e].second == v) edges.push_back(EdgeSet{1} << e);
    }
    for (size_t a = 0; a < edges.size(); ++a) {
      for (size_t b = a + 1; b < edges.size(); ++b) {
        if (Allows(p, caution, edges[a] | edges[b])) corners.push_back(edges[a] | edges[b]);
      }
    }
  }
  return corners;
}

class Search {
 public:
  Search(const PData& p, const FaceSearchReading& reading)
      : order_(reading.order),
        edges_(p.columns() - 1),
        loops_(FindLoops(p, reading.caution)),
        faces_(FaceSets(p)) {
    if (order_ == LoopOrder::kCornerByCorner) corners_ = Corners(p, reading.caution);
  }

  FaceSearchOutcome Run() {
    Choose();
    return outcome_;
  }

 private:
  bool IsFace(EdgeSet loop) const { return std::binary_search(faces_.begin(), faces_.end(), loop); }

  // What comes next, given faces_ chosen so far: every choice.
  void Choose() {
    std::vector<EdgeSet> state = chosen_;
    std::sort(state.begin(), state.end());
    if (!visited_.insert(state).second) return;
    EdgeSet once = 0, twice = 0;
    for (const EdgeSet face : chosen_) {
      twice |= once & face;
      once |= face;
    }
    const EdgeSet all = edges_ == 32 ? ~EdgeSet{0} : (EdgeSet{1} << edges_) - 1;
    if (twice == all) {
      outcome_.right = true;
      return;
    }
    const EdgeSet wanted = Wanted(twice);
    std::vector<EdgeSet> next;
    for (const EdgeSet loop : loops_) {
      if ((loop & twice) != 0 || (loop & wanted) != wanted) continue;
      if (std::binary_search(state.begin(), state.end(), loop)) continue;
      if (!next.empty() && std::popcount(loop) > std::popcount(next.front())) break;
      next.push_back(loop);
    }
    if (next.empty()) Fail(true);
    for (const EdgeSet loop : next) {
      chosen_.push_back(loop);
      if (IsFace(loop)) {
        Choose();
      } else {
        Fail(false);
      }
      chosen_.pop_back();
    }
  }

  // What the next loop has to include.
  EdgeSet Wanted(EdgeSet twice) const {
    if (order_ == LoopOrder::kEdgeByEdge) return ~twice & (twice + 1);
    for (const EdgeSet corner : corners_) {
      const auto has = [&](EdgeSet face) { return (face & corner) == corner; };
      if (std::none_of(chosen_.begin(), chosen_.end(), has)) return corner;
    }
    return 0;
  }

  void Fail(bool stuck) {
    if (outcome_.wrong && !(outcome_.stuck && !stuck)) return;
    outcome_.wrong = true;
    outcome_.stuck = stuck;
    outcome_.chosen = chosen_;
  }

  LoopOrder order_;
  int edges_;
  std::vector<EdgeSet> loops_, faces_, corners_, chosen_;
  std::set<std::vector<EdgeSet>> visited_;
  FaceSearchOutcome outcome_;
};

}  // namespace

bool Allows(const PData& p, Caution caution, EdgeSet loop) {
  const int n = p.columns();
  for (int i = 2; i < n && caution != Caution::kNone; ++i) {
    const bool four_edges = p.sigma(i) != 1 && p.sigma(i) != n;
    if (!four_edges && caution != Caution::kEveryVertex) continue;
    const int later = caution == Caution::kSegments ? i - 1 : i;
    if (later > 1 && (loop & Bit(later - 1)) != 0 && (loop & Bit(later)) != 0) return false;
  }
  return true;
}

std::vector<EdgeSet> FindLoops(const PData& p, Caution caution) {
  if (p.columns() > 33) {
    throw PreconditionError("FindLoops: expected at most 32 edges, got " + std::to_string(p.columns() - 1));
  }
  std::vector<EdgeSet> loops = SimpleLoops(KnotGraph(p));
  std::erase_if(loops, [&](EdgeSet loop) { return !Allows(p, caution, loop); });
  std::stable_sort(loops.begin(), loops.end(),
                   [](EdgeSet a, EdgeSet b) { return std::popcount(a) < std::popcount(b); });
  return loops;
}

std::vector<EdgeSet> FaceSets(const PData& p) {
  std::vector<EdgeSet> faces;
  for (const EdgeWalk& walk : KnotGraphFaces(p)) {
    EdgeSet face = 0;
    for (const int k : walk) face |= Bit(k);
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

FaceSearchOutcome SearchFaces(const PData& p, const FaceSearchReading& reading) {
  return Search(p, reading).Run();
}

}  // namespace tact::knot::thesis

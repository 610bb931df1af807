#include "algebra/knot/diagram_triangulation.h"

#include <algorithm>

#include "algebra/error.h"

namespace tact::knot {
namespace {

using Walk = std::vector<int>;

bool RepeatsAVertex(Walk walk) {
  std::sort(walk.begin(), walk.end());
  return std::adjacent_find(walk.begin(), walk.end()) != walk.end();
}

class Builder {
 public:
  Builder(const PData& p, const std::vector<int>& more)
      : p_(p), more_(more), first_(static_cast<size_t>(p.segments()) + 2) {
    intersection_.resize(static_cast<size_t>(p.columns()) + 1);
    for (int i = 1; i <= p.columns(); ++i) {
      if (p.sigma(i) > i) intersection_[At(i)] = intersection_[At(p.sigma(i))] = result_.vertices++;
    }
    for (int s = 1; s <= p.segments(); ++s) LayRope(s);
    result_.rope.push_back(result_.vertices++);
  }

  DiagramTriangulation Fill(int outer) {
    const Faces faces(p_);
    for (int face = 0; face < faces.count(); ++face) {
      if (face != outer) FillInner(WalkOf(faces.walk(face)));
    }
    result_.boundary = FillRing(WalkOf(faces.walk(outer)));
    return std::move(result_);
  }

 private:
  static size_t At(int i) { return static_cast<size_t>(i); }

  // What segment s starts in, and its points.
  void LayRope(int s) {
    first_[At(s)] = static_cast<int>(result_.rope.size());
    if (s > 1) result_.place.push_back(first_[At(s)]);
    result_.rope.push_back(s == 1 ? result_.vertices++ : intersection_[At(s - 1)]);
    const bool returns = s > 1 && s <= p_.columns() && p_.sigma(s) == s - 1;
    const int points = (returns ? 2 : 1) + (more_.empty() ? 0 : more_[At(s - 1)]);
    for (int k = 0; k < points; ++k) result_.rope.push_back(result_.vertices++);
    first_[At(s) + 1] = static_cast<int>(result_.rope.size());
  }

  // The vertices round a face, each where an edge of the walk begins.
  Walk WalkOf(const std::vector<Dart>& darts) const {
    Walk walk;
    for (const Dart d : darts) {
      const int begin = first_[At(d.segment)], end = first_[At(d.segment) + 1];
      for (int k = 0; k < end - begin; ++k) walk.push_back(result_.rope[At(d.forward ? begin + k : end - k)]);
    }
    return walk;
  }

  void FillInner(const Walk& walk) { FillFan(RepeatsAVertex(walk) ? FillRing(walk) : walk); }

  void FillFan(const Walk& walk) {
    const int center = result_.vertices++;
    for (size_t i = 0; i < walk.size(); ++i)
      result_.triangles.push_back({walk[i], walk[(i + 1) % walk.size()], center});
  }

  std::vector<int> FillRing(const Walk& walk) {
    std::vector<int> ring(walk.size());
    for (int& vertex : ring) vertex = result_.vertices++;
    for (size_t i = 0; i < walk.size(); ++i) {
      const size_t next = (i + 1) % walk.size();
      result_.triangles.push_back({walk[i], walk[next], ring[i]});
      result_.triangles.push_back({walk[next], ring[next], ring[i]});
    }
    return ring;
  }

  const PData& p_;
  const std::vector<int>& more_;
  DiagramTriangulation result_;
  std::vector<int> intersection_;  // the vertex of each column
  std::vector<int> first_;         // where each segment begins in the rope
};

// How far the farthest face is.
int DepthFrom(int outer, const std::vector<std::vector<int>>& neighbours) {
  std::vector<int> distance(neighbours.size(), -1), reached = {outer};
  distance[static_cast<size_t>(outer)] = 0;
  for (size_t k = 0; k < reached.size(); ++k) {
    const auto at = static_cast<size_t>(reached[k]);
    for (const int next : neighbours[at]) {
      if (distance[static_cast<size_t>(next)] >= 0) continue;
      distance[static_cast<size_t>(next)] = distance[at] + 1;
      reached.push_back(next);
    }
  }
  return distance[static_cast<size_t>(reached.back())];
}

}  // namespace

DiagramTriangulation TriangulateDiagram(const PData& p, int outer, const std::vector<int>& more) {
  if (const int genus = Genus(p); genus != 0)
    throw PreconditionError("TriangulateDiagram: expected P-data of a sphere, got genus " +
                            std::to_string(genus));
  if (outer < 0 || outer > p.crossings())
    throw PreconditionError("TriangulateDiagram: expected a face from 0 to " + std::to_string(p.crossings()) +
                            ", got " + std::to_string(outer));
  if (!more.empty() && more.size() != static_cast<size_t>(p.segments()))
    throw PreconditionError("TriangulateDiagram: expected a number of points for each segment");
  return Builder(p, more).Fill(outer);
}

int BestOuterFace(const Faces& faces, int segments) {
  std::vector<std::vector<int>> neighbours(static_cast<size_t>(faces.count()));
  for (int s = 1; s <= segments; ++s) {
    const int left = faces.left_of({s, true}), right = faces.left_of({s, false});
    neighbours[static_cast<size_t>(left)].push_back(right);
    neighbours[static_cast<size_t>(right)].push_back(left);
  }
  std::vector<int> depth;
  for (int outer = 0; outer < faces.count(); ++outer) depth.push_back(DepthFrom(outer, neighbours));
  const int least = *std::min_element(depth.begin(), depth.end());
  int best = -1;
  for (int face = 0; face < faces.count(); ++face) {
    if (depth[static_cast<size_t>(face)] > least + 1) continue;
    if (best < 0 || faces.walk(face).size() > faces.walk(best).size()) best = face;
  }
  return best;
}

}  // namespace tact::knot

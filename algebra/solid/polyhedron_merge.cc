// Coplanar neighbours become faces with loops. Loops are traced through the rotation of half-edges around
// each corner, so the sectors of a face that touches itself at a point are kept apart.
#include <algorithm>
#include <numeric>

#include "algebra/error.h"
#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {
namespace {

constexpr size_t kNone = SoupDefect::kNone;

class Merger {
 public:
  explicit Merger(const SoupMesh& mesh) : mesh_(mesh) {}

  MergedFaces Run() {
    FindKept();
    FindFaces();
    FindVertices();
    FindEdges();
    FindLoops();
    ListAroundVertices();
    merged_.solid.shells = mesh_.shells;
    return std::move(merged_);
  }

 private:
  const HalfEdge& At(size_t h) const { return mesh_.half_edges[h]; }
  // The next half-edge out of the same corner, counter-clockwise seen from outside.
  size_t CounterClockwise(size_t h) const { return At(At(h).previous).twin; }
  // The half-edge that continues the boundary of h's face behind h's head.
  size_t Following(size_t h) const {
    size_t n = At(h).next;
    while (!kept_[n]) n = At(At(n).twin).next;
    return n;
  }

  // A half-edge is kept if its two polygons lie in different planes.
  void FindKept() {
    kept_.resize(mesh_.half_edges.size());
    for (size_t h = 0; h < kept_.size(); ++h) {
      kept_[h] = mesh_.normals[At(h).polygon] != mesh_.normals[At(At(h).twin).polygon];
    }
  }

  void FindFaces() {
    face_.assign(mesh_.normals.size(), kNone);
    for (size_t start = 0; start < face_.size(); ++start) {
      if (face_[start] != kNone) continue;
      const size_t number = merged_.solid.faces.size();
      merged_.solid.faces.push_back({mesh_.normals[start], mesh_.offsets[start], {}, {}, mesh_.shell[start]});
      merged_.first_polygon.push_back(start);
      std::vector<size_t> pending{start};
      face_[start] = number;
      while (!pending.empty()) {
        const size_t polygon = pending.back();
        pending.pop_back();
        for (size_t h = mesh_.first[polygon]; h < mesh_.first[polygon + 1]; ++h) {
          const size_t neighbour = At(At(h).twin).polygon;
          if (kept_[h] || face_[neighbour] != kNone) continue;
          face_[neighbour] = number;
          pending.push_back(neighbour);
        }
      }
    }
  }

  // A fan with two kept edges is straight-through, one with none is inside a face.
  void FindVertices() {
    std::vector<size_t> starts;
    vertex_.assign(mesh_.half_edges.size(), kNone);
    std::vector<bool> seen(mesh_.half_edges.size());
    for (size_t h = 0; h < seen.size(); ++h) {
      if (seen[h]) continue;
      size_t count = 0, start = kNone;
      for (size_t k = h; !seen[k]; k = CounterClockwise(k)) {
        seen[k] = true;
        if (!kept_[k]) continue;
        ++count;
        start = std::min(start, k);
      }
      if (count > 2) starts.push_back(start);
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [&](size_t a, size_t b) { return At(a).tail < At(b).tail; });
    for (const size_t start : starts) {
      const size_t number = merged_.solid.vertices.size();
      merged_.solid.vertices.push_back(
          {mesh_.points[At(start).tail], {}, {}, mesh_.shell[At(start).polygon]});
      fan_start_.push_back(start);
      size_t k = start;
      do {
        vertex_[k] = number;
        k = CounterClockwise(k);
      } while (k != start);
    }
  }

  // Chains of kept half-edges from vertex to vertex.
  void FindEdges() {
    edge_.assign(mesh_.half_edges.size(), kNone);
    successor_.assign(mesh_.half_edges.size(), kNone);
    for (size_t h = 0; h < edge_.size(); ++h) {
      if (!kept_[h] || vertex_[h] == kNone) continue;
      size_t last = h;
      while (vertex_[Following(last)] == kNone) last = Following(last);
      successor_[h] = Following(last);
      const size_t back = At(last).twin;
      if (edge_[back] != kNone) {
        edge_[h] = edge_[back];
        continue;
      }
      edge_[h] = merged_.solid.edges.size();
      merged_.solid.edges.push_back(MakeEdge(h, successor_[h]));
    }
  }

  Edge MakeEdge(size_t first, size_t behind) const {
    const size_t tail = vertex_[first], head = vertex_[behind];
    const size_t left = At(first).polygon, right = At(At(first).twin).polygon;
    const Vector3 along = merged_.solid.vertices[head].point - merged_.solid.vertices[tail].point;
    const int bend = Dot(Cross(mesh_.normals[left], mesh_.normals[right]), along).sign();
    if (bend == 0) throw InvariantError("an edge between faces of one plane");
    return {tail, head, face_[left], face_[right], bend > 0 ? Convexity::kConvex : Convexity::kConcave};
  }

  void FindLoops() {
    std::vector<bool> seen(mesh_.half_edges.size());
    for (size_t h = 0; h < seen.size(); ++h) {
      if (successor_[h] == kNone || seen[h]) continue;
      std::vector<size_t> loop, loop_edges;
      for (size_t k = h; !seen[k]; k = successor_[k]) {
        seen[k] = true;
        loop.push_back(vertex_[k]);
        loop_edges.push_back(edge_[k]);
      }
      Face& face = merged_.solid.faces[face_[At(h).polygon]];
      face.loops.push_back(std::move(loop));
      face.loop_edges.push_back(std::move(loop_edges));
    }
    for (Face& face : merged_.solid.faces) PutOuterLoopFirst(&face);
  }

  void PutOuterLoopFirst(Face* face) const {
    const PlanarRegion region = RegionOf(merged_.solid, *face);
    std::vector<size_t> outer;
    for (size_t i = 0; i < region.loops.size(); ++i) {
      if (Dot(DoubleArea(region.loops[i]), face->normal).sign() > 0) outer.push_back(i);
    }
    if (outer.size() != 1) throw InvariantError("a face without exactly one outer loop");
    const auto o = static_cast<std::ptrdiff_t>(outer[0]);
    std::rotate(face->loops.begin(), face->loops.begin() + o, face->loops.begin() + o + 1);
    std::rotate(face->loop_edges.begin(), face->loop_edges.begin() + o, face->loop_edges.begin() + o + 1);
  }

  void ListAroundVertices() {
    for (size_t v = 0; v < fan_start_.size(); ++v) {
      Vertex& vertex = merged_.solid.vertices[v];
      size_t k = fan_start_[v];
      do {
        if (kept_[k]) {
          vertex.edges.push_back(edge_[k]);
          vertex.faces.push_back(face_[At(k).polygon]);
        }
        k = CounterClockwise(k);
      } while (k != fan_start_[v]);
    }
  }

  const SoupMesh& mesh_;
  MergedFaces merged_;
  std::vector<bool> kept_;
  std::vector<size_t> face_;       // of each polygon
  std::vector<size_t> vertex_;     // at each half-edge's tail
  std::vector<size_t> fan_start_;  // of each vertex
  std::vector<size_t> edge_;       // of each kept half-edge that starts at a vertex
  std::vector<size_t> successor_;  // the half-edge that starts the next edge of the loop
};

}  // namespace

MergedFaces MergeFaces(const SoupMesh& mesh) { return Merger(mesh).Run(); }

}  // namespace tact::algebra

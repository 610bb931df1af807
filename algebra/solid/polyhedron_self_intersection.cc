// Self-intersections of a shell: every edge against every polygon, culled by boxes. Two polygons that meet
// at more than common corners and edges always have an edge of one meeting the other.
#include "algebra/solid/box_sweep.h"
#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {
namespace {

bool IsTriangleEdge(const SoupMesh& mesh, size_t half_edge, size_t polygon) {
  const size_t corners = mesh.first[polygon + 1] - mesh.first[polygon];
  const HalfEdge& h = mesh.half_edges[half_edge];
  return corners == 3 && (h.polygon == polygon || mesh.half_edges[h.twin].polygon == polygon);
}

}  // namespace

void RefuseSelfIntersections(const SoupMesh& mesh) {
  std::vector<PlanarRegion> regions;
  std::vector<Box> polygon_boxes(mesh.normals.size());
  for (size_t i = 0; i < mesh.normals.size(); ++i) {
    regions.push_back(mesh.Region(i));
    for (const Vector3* corner : regions[i].loops[0]) polygon_boxes[i].Add(*corner);
  }
  std::vector<size_t> edges;
  std::vector<Box> edge_boxes;
  for (size_t h = 0; h < mesh.half_edges.size(); ++h) {
    if (mesh.half_edges[h].twin < h) continue;
    edges.push_back(h);
    Box& box = edge_boxes.emplace_back();
    box.Add(mesh.points[mesh.half_edges[h].tail]);
    box.Add(mesh.points[mesh.half_edges[h].head]);
  }
  SweepOverlaps(edge_boxes, polygon_boxes, [&](size_t edge, size_t polygon) {
    const HalfEdge& h = mesh.half_edges[edges[edge]];
    if (mesh.shell[h.polygon] != mesh.shell[polygon]) return true;
    if (IsTriangleEdge(mesh, edges[edge], polygon)) return true;
    const Vector3& tail = mesh.points[h.tail];
    const Vector3& head = mesh.points[h.head];
    const auto met = UnsharedPoint(regions[polygon], tail, head);
    if (!met) return true;
    Refuse("the surface meets itself at " + PointText(*met) + ": the edge from " + PointText(tail) + " to " +
               PointText(head) + " of " + PolygonText(h.polygon) +
               " runs into this polygon; correct the points, or cut both where they meet",
           polygon);
  });
}

}  // namespace tact::algebra

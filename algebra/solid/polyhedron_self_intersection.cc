// Self-intersections of a shell: every edge against every polygon, culled by boxes. Two polygons that meet
// at more than common corners and edges always have an edge of one meeting the other.
#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/solid/box_sweep.h"
#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {
namespace {

bool IsTriangleEdge(const SoupMesh& mesh, size_t half_edge, size_t polygon) {
  const size_t corners = mesh.first[polygon + 1] - mesh.first[polygon];
  const HalfEdge& h = mesh.half_edges[half_edge];
  return corners == 3 && (h.polygon == polygon || mesh.half_edges[h.twin].polygon == polygon);
}

// Which side of a polygon's plane points are on, where doubles leave no doubt.
class RoundedPlane {
 public:
  RoundedPlane(const Vector3& normal, const Rational& offset)
      : normal_(ToDouble(normal)), offset_(ToDouble(offset)) {}

  // 1 or -1 if that is certainly the sign of normal . point - offset, else 0.
  int CertainSide(const std::array<double, 3>& point) const {
    // A dozen relative roundings of at most 2^-52 each, and coordinates that vanish below the floor.
    constexpr double kRoundings = 1e-14, kFloor = 1e-300;
    double height = -offset_, doubt = kRoundings * std::abs(offset_);
    for (size_t i = 0; i < 3; ++i) {
      height += normal_[i] * point[i];
      doubt += std::abs(normal_[i]) * (kRoundings * std::abs(point[i]) + kFloor);
    }
    return height > doubt ? 1 : (height < -doubt ? -1 : 0);
  }

 private:
  std::array<double, 3> normal_;
  double offset_;
};

}  // namespace

void RefuseSelfIntersections(const SoupMesh& mesh) {
  std::vector<std::array<double, 3>> rounded_points;
  for (const Vector3& point : mesh.points) rounded_points.push_back(ToDouble(point));
  std::vector<RoundedPlane> rounded_planes;
  std::vector<PlanarRegion> regions;
  std::vector<BoundingBox> polygon_boxes(mesh.normals.size());
  for (size_t i = 0; i < mesh.normals.size(); ++i) {
    regions.push_back(mesh.Region(i));
    rounded_planes.emplace_back(mesh.normals[i], mesh.offsets[i]);
    for (const Vector3* corner : regions[i].loops[0]) polygon_boxes[i].Add(*corner);
  }
  std::vector<size_t> edges;
  std::vector<BoundingBox> edge_boxes;
  for (size_t h = 0; h < mesh.half_edges.size(); ++h) {
    if (mesh.half_edges[h].twin < h) continue;
    edges.push_back(h);
    BoundingBox& box = edge_boxes.emplace_back();
    box.Add(mesh.points[mesh.half_edges[h].tail]);
    box.Add(mesh.points[mesh.half_edges[h].head]);
  }
  // Whether an edge certainly meets the polygon's plane in a corner that they share, or not at all.
  const auto is_apart = [&](const HalfEdge& h, size_t polygon) {
    int sides[2] = {0, 0}, end = 0;
    for (const size_t point : {h.tail, h.head}) {
      bool is_corner = false;
      for (size_t k = mesh.first[polygon]; k < mesh.first[polygon + 1]; ++k) {
        is_corner = is_corner || mesh.half_edges[k].tail == point;
      }
      sides[end] = is_corner ? 0 : rounded_planes[polygon].CertainSide(rounded_points[point]);
      if (!is_corner && sides[end] == 0) return false;
      ++end;
    }
    return sides[0] != -sides[1];
  };
  SweepOverlaps(edge_boxes, polygon_boxes, [&](size_t edge, size_t polygon) {
    const HalfEdge& h = mesh.half_edges[edges[edge]];
    if (mesh.shell[h.polygon] != mesh.shell[polygon]) return true;
    if (IsTriangleEdge(mesh, edges[edge], polygon) || is_apart(h, polygon)) return true;
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

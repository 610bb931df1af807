#include "algebra/solid/soup_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tact::algebra {
namespace {

constexpr size_t kNone = SoupDefect::kNone;

// The number of each point of the soup among the distinct ones.
std::vector<size_t> UniquePoints(const std::vector<Vector3>& points, std::vector<Vector3>* distinct) {
  std::vector<size_t> order(points.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return points[a] < points[b]; });
  std::vector<size_t> representative(points.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
    representative[order[i]] = repeats ? representative[order[i - 1]] : order[i];
  }
  std::vector<size_t> number(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    if (representative[i] == i) {
      number[i] = distinct->size();
      distinct->push_back(points[i]);
    } else {
      number[i] = number[representative[i]];
    }
  }
  return number;
}

void CheckCorners(const PolygonSoup& soup, size_t polygon, const std::vector<size_t>& number) {
  const std::vector<size_t>& corners = soup.polygons[polygon];
  if (corners.size() < 3) {
    Refuse("it has " + std::to_string(corners.size()) + " corners, expected 3 or more; remove the polygon",
           polygon);
  }
  for (const size_t corner : corners) {
    if (corner >= soup.points.size()) {
      Refuse("it refers to point " + std::to_string(corner) + " (counting from 0), but there are only " +
                 std::to_string(soup.points.size()) + " points; correct the index",
             polygon);
    }
  }
  std::vector<size_t> sorted;
  for (const size_t corner : corners) sorted.push_back(number[corner]);
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return;
  for (size_t i = 0; i < corners.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (number[corners[i]] != number[corners[j]]) continue;
      Refuse("corner " + PointText(soup.points[corners[i]]) +
                 " occurs twice; give each corner once, and split a polygon that touches itself",
             polygon);
    }
  }
}

// The plane through the first three corners that are not collinear must hold the others.
void AddPlane(size_t polygon, SoupMesh* mesh) {
  std::vector<const Vector3*> corners;
  for (size_t h = mesh->first[polygon]; h < mesh->first[polygon + 1]; ++h) {
    corners.push_back(&mesh->points[mesh->half_edges[h].tail]);
  }
  const Vector3& origin = *corners[0];
  const Vector3 along = *corners[1] - origin;
  Vector3 normal;
  const Vector3* third = nullptr;
  for (size_t i = 2; i < corners.size() && normal.IsZero(); ++i) {
    third = corners[i];
    normal = Primitive(Cross(along, *third - origin));
  }
  if (normal.IsZero()) {
    Refuse("its corners lie on one line, through " + PointText(origin) + " and " + PointText(*corners[1]) +
               ", so it has zero area; remove it and give its neighbours the missing corners",
           polygon);
  }
  const Rational offset = Dot(normal, origin);
  const Vector3* farthest = nullptr;
  Rational most;
  for (const Vector3* corner : corners) {
    const Rational height = Abs(Dot(normal, *corner) - offset);
    if (height <= most) continue;
    most = height;
    farthest = corner;
  }
  if (farthest != nullptr) {
    const double distance = ToDouble(most) / std::sqrt(ToDouble(Dot(normal, normal)));
    Refuse("it is not planar: corner " + PointText(*farthest) + " is " + ApproximateText(distance) +
               " off the plane through " + PointText(origin) + ", " + PointText(*corners[1]) + " and " +
               PointText(*third) + "; correct the corner or split the polygon into triangles",
           polygon);
  }
  const int sign = Dot(DoubleArea(corners), normal).sign();
  if (sign == 0) {
    Refuse("its boundary crosses itself and encloses zero area, near " + PointText(origin) +
               "; correct the order of its corners",
           polygon);
  }
  mesh->normals.push_back(sign > 0 ? normal : -normal);
  mesh->offsets.push_back(sign > 0 ? offset : -offset);
}

// A half-edge together with the indices the soup wrote for its ends.
struct Written {
  size_t half_edge, low, high;
};

std::string EdgeText(const SoupMesh& mesh, const HalfEdge& h) {
  return PointText(mesh.points[h.tail]) + " to " + PointText(mesh.points[h.head]);
}

[[noreturn]] void RefuseEdge(const SoupMesh& mesh, const std::vector<Written>& group) {
  const HalfEdge& h = mesh.half_edges[group[0].half_edge];
  const std::string edge = "the edge from " + EdgeText(mesh, h);
  if (group.size() == 1) {
    Refuse(edge + " has no second polygon, so the surface is open; add the missing polygon", h.polygon);
  }
  if (group.size() == 2) {
    const size_t other = mesh.half_edges[group[1].half_edge].polygon;
    Refuse(edge + " is run in the same direction by " + PolygonText(other) +
               ", so one of the two is flipped; reverse the corners of the one whose normal points inwards",
           h.polygon);
  }
  std::string others;
  for (size_t i = 1; i < group.size(); ++i) {
    others += (i == 1 ? "" : ", ") + PolygonText(mesh.half_edges[group[i].half_edge].polygon);
  }
  Refuse(edge + " is shared by " + std::to_string(group.size()) + " polygons, also by " + others +
             ", expected 2; separate the parts, or give touching bodies points of their own",
         h.polygon);
}

bool PairTwins(const std::vector<Written>& group, SoupMesh* mesh) {
  if (group.size() != 2) return false;
  HalfEdge& a = mesh->half_edges[group[0].half_edge];
  HalfEdge& b = mesh->half_edges[group[1].half_edge];
  if (a.tail != b.head) return false;
  a.twin = group[1].half_edge;
  b.twin = group[0].half_edge;
  return true;
}

// Where bodies touch along an edge, the indices that the soup wrote tell them apart.
bool PairTwinsAsWritten(const std::vector<Written>& group, SoupMesh* mesh) {
  std::map<std::pair<size_t, size_t>, std::vector<Written>> bodies;
  for (const Written& w : group) bodies[{w.low, w.high}].push_back(w);
  return std::all_of(bodies.begin(), bodies.end(),
                     [&](const auto& body) { return PairTwins(body.second, mesh); });
}

using EdgeGroups = std::vector<std::vector<Written>>;

// Half-edges between the same two points, in order of their first one.
EdgeGroups GroupHalfEdges(const PolygonSoup& soup, const SoupMesh& mesh) {
  std::map<std::pair<size_t, size_t>, size_t> known;
  EdgeGroups groups;
  for (size_t i = 0; i < soup.polygons.size(); ++i) {
    const std::vector<size_t>& corners = soup.polygons[i];
    for (size_t k = 0; k < corners.size(); ++k) {
      const size_t a = corners[k], b = corners[(k + 1) % corners.size()];
      const HalfEdge& h = mesh.half_edges[mesh.first[i] + k];
      const auto [place, is_new] = known.try_emplace(std::minmax(h.tail, h.head), groups.size());
      if (is_new) groups.emplace_back();
      groups[place->second].push_back({mesh.first[i] + k, std::min(a, b), std::max(a, b)});
    }
  }
  return groups;
}

void FindShells(SoupMesh* mesh) {
  mesh->shell.assign(mesh->first.size() - 1, kNone);
  for (size_t start = 0; start < mesh->shell.size(); ++start) {
    if (mesh->shell[start] != kNone) continue;
    std::vector<size_t> pending{start};
    mesh->shell[start] = mesh->shells;
    while (!pending.empty()) {
      const size_t polygon = pending.back();
      pending.pop_back();
      for (size_t h = mesh->first[polygon]; h < mesh->first[polygon + 1]; ++h) {
        const size_t neighbour = mesh->half_edges[mesh->half_edges[h].twin].polygon;
        if (mesh->shell[neighbour] != kNone) continue;
        mesh->shell[neighbour] = mesh->shells;
        pending.push_back(neighbour);
      }
    }
    ++mesh->shells;
  }
}

void RefuseFolds(const SoupMesh& mesh) {
  for (const HalfEdge& h : mesh.half_edges) {
    const size_t other = mesh.half_edges[h.twin].polygon;
    if (mesh.normals[h.polygon] != -mesh.normals[other]) continue;
    Refuse("it is folded onto " + PolygonText(other) + " along the edge from " + EdgeText(mesh, h) +
               ", leaving zero thickness; remove both or give the part thickness",
           h.polygon);
  }
}

}  // namespace

PlanarRegion SoupMesh::Region(size_t polygon) const {
  PlanarRegion region{normals[polygon], offsets[polygon], ProjectionAxes(normals[polygon]), {{}}};
  for (size_t h = first[polygon]; h < first[polygon + 1]; ++h) {
    region.loops[0].push_back(&points[half_edges[h].tail]);
  }
  return region;
}

SoupMesh BuildSoupMesh(const PolygonSoup& soup) {
  if (soup.polygons.empty()) Refuse("there is no polygon, expected a closed surface", kNone);
  SoupMesh mesh;
  const std::vector<size_t> number = UniquePoints(soup.points, &mesh.points);
  for (size_t i = 0; i < soup.polygons.size(); ++i) {
    CheckCorners(soup, i, number);
    const std::vector<size_t>& corners = soup.polygons[i];
    const size_t first = mesh.half_edges.size(), count = corners.size();
    mesh.first.push_back(first);
    for (size_t k = 0; k < count; ++k) {
      mesh.half_edges.push_back({number[corners[k]], number[corners[(k + 1) % count]],
                                 first + (k + 1) % count, first + (k + count - 1) % count, kNone, i});
    }
  }
  mesh.first.push_back(mesh.half_edges.size());
  for (size_t i = 0; i < soup.polygons.size(); ++i) AddPlane(i, &mesh);

  const EdgeGroups groups = GroupHalfEdges(soup, mesh);
  for (const auto& group : groups) {
    if (!PairTwins(group, &mesh) && !PairTwinsAsWritten(group, &mesh)) RefuseEdge(mesh, group);
  }
  FindShells(&mesh);
  for (const auto& group : groups) {
    std::vector<size_t> shells;
    for (const Written& w : group) shells.push_back(mesh.shell[mesh.half_edges[w.half_edge].polygon]);
    std::sort(shells.begin(), shells.end());
    for (size_t i = 2; i < shells.size(); ++i) {
      if (shells[i] == shells[i - 2]) RefuseEdge(mesh, group);
    }
  }
  RefuseFolds(mesh);
  return mesh;
}

}  // namespace tact::algebra

#include "robot/recognition/proximity_solid.h"

#include <algorithm>
#include <cmath>

namespace tact::recognition {
namespace {

using Eigen::Vector3d;

double DistanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
  return (a + share * along - p).norm();
}

}  // namespace

ProximitySolid::ProximitySolid(const algebra::Polyhedron& solid) : solid_(ToDouble(solid)) {
  edges_at_.resize(solid_.vertices.size());
  for (const algebra::Vertex& vertex : solid.vertices) faces_at_.push_back(vertex.faces);
  for (size_t e = 0; e < solid.edges.size(); ++e) {
    const algebra::Edge& edge = solid.edges[e];
    const Vector3d along = (solid_.edges[e].head - solid_.edges[e].tail).normalized();
    edges_at_[edge.tail].push_back(along);
    edges_at_[edge.head].push_back(-along);
    // The left face's boundary runs tail to head, the right one's back.
    wings_.push_back(
        {solid_.faces[edge.left].normal.cross(along), along.cross(solid_.faces[edge.right].normal)});
    convex_.push_back(edge.convexity == algebra::Convexity::kConvex);
  }
  for (const algebra::Face& face : solid.faces) loops_.push_back(face.loops);
}

bool ProximitySolid::Encloses(size_t face, const Vector3d& foot) const {
  // Seen along the axis that the plane is squarest to.
  int axis = 0;
  solid_.faces[face].normal.cwiseAbs().maxCoeff(&axis);
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  bool inside = false;
  for (const auto& loop : loops_[face]) {
    const Vector3d* a = &solid_.vertices[loop.back()];
    for (const size_t next : loop) {
      const Vector3d* b = &solid_.vertices[next];
      if (((*a)[y] > foot[y]) != ((*b)[y] > foot[y]) &&
          foot[x] < (*a)[x] + (foot[y] - (*a)[y]) / ((*b)[y] - (*a)[y]) * ((*b)[x] - (*a)[x]))
        inside = !inside;
      a = b;
    }
  }
  return inside;
}

Vector3d ProximitySolid::middle() const {
  Vector3d low = solid_.vertices.front(), high = low;
  for (const Vector3d& p : solid_.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (low + high) / 2;
}

double ProximitySolid::diameter() const {
  double largest = 0;
  for (const Vector3d& a : solid_.vertices) {
    for (const Vector3d& b : solid_.vertices) largest = std::max(largest, (a - b).norm());
  }
  return largest;
}

double ProximitySolid::AsideOfFace(size_t face, const Vector3d& p) const {
  const auto& plane = solid_.faces[face];
  const Vector3d foot = p - (plane.normal.dot(p) - plane.offset) * plane.normal;
  if (Encloses(face, foot)) return 0;
  double rim = HUGE_VAL;
  for (const auto& loop : loops_[face]) {
    const Vector3d* a = &solid_.vertices[loop.back()];
    for (const size_t next : loop) {
      const Vector3d* b = &solid_.vertices[next];
      rim = std::min(rim, DistanceToSegment(foot, *a, *b));
      a = b;
    }
  }
  return rim;
}

double ProximitySolid::DistanceToFace(size_t face, const Vector3d& p) const {
  const auto& plane = solid_.faces[face];
  return std::hypot(plane.normal.dot(p) - plane.offset, AsideOfFace(face, p));
}

double ProximitySolid::DistanceToSurface(const Vector3d& p) const {
  double nearest = HUGE_VAL;
  for (size_t f = 0; f < solid_.faces.size(); ++f) nearest = std::min(nearest, DistanceToFace(f, p));
  return nearest;
}

double ProximitySolid::DepthOf(const Vector3d& p) const {
  // How often a ray leaves, faces crossed by it counted odd or even; its direction is parallel to no face that people draw.
  const Vector3d ray(0.5409713, 0.3762153, 0.7522179);
  bool inside = false;
  for (size_t f = 0; f < solid_.faces.size(); ++f) {
    const auto& face = solid_.faces[f];
    const double slope = face.normal.dot(ray), way = face.offset - face.normal.dot(p);
    if (slope == 0 || way / slope <= 0) continue;
    if (Encloses(f, p + way / slope * ray)) inside = !inside;
  }
  return inside ? DistanceToSurface(p) : 0;
}

}  // namespace tact::recognition

#include "robot/recognition/near_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tact::recognition {
namespace {

using algebra::Polyhedron;
using Eigen::Vector3d;
using joint::Transform;

// The distance of a point in a face's plane from the face.
double FromFace(const Polyhedron& solid, const SolidF& solid_f, size_t face, const Vector3d& point) {
  const Vector3d& n = solid_f.faces[face].normal;
  int axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  bool inside = false;
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& loop : solid.faces[face].loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3d& a = solid_f.vertices[loop[i]];
      const Vector3d& b = solid_f.vertices[loop[(i + 1) % loop.size()]];
      if ((a[v] > point[v]) != (b[v] > point[v]) &&
          point[u] < a[u] + (b[u] - a[u]) * (point[v] - a[v]) / (b[v] - a[v]))
        inside = !inside;
      const Vector3d along = b - a;
      const double part = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      distance = std::min(distance, (point - a - part * along).norm());
    }
  }
  return inside ? 0 : distance;
}

// How far beyond the ends of an edge a point of its line is.
double BeyondEdge(const SolidF::EdgeF& edge, const Vector3d& point) {
  const Vector3d along = edge.head - edge.tail;
  const double length = along.norm(), at = (point - edge.tail).dot(along) / length;
  return std::max({0.0, -at, at - length});
}

// No edge at the vertex goes below the plane by more than the angle.
bool StandsOn(const Polyhedron& solid, const SolidF& solid_f, size_t vertex, const Vector3d& up,
              double sine) {
  for (const size_t e : solid.vertices[vertex].edges) {
    const auto& edge = solid_f.edges[e];
    const Vector3d away =
        solid.edges[e].tail == vertex ? Vector3d(edge.head - edge.tail) : Vector3d(edge.tail - edge.head);
    if (away.normalized().dot(up) < -sine) return false;
  }
  return true;
}

// The direction is a normal that the convex edge has, to the angle.
bool IsNormalAt(const Polyhedron& solid, const SolidF& solid_f, size_t edge, const Vector3d& n, double sine) {
  const auto& e = solid.edges[edge];
  const auto& ends = solid_f.edges[edge];
  const Vector3d along = (ends.head - ends.tail).normalized();
  // Into the faces, away from the edge: the left face is to the left of the edge seen from outside.
  const Vector3d left = solid_f.faces[e.left].normal.cross(along),
                 right = along.cross(solid_f.faces[e.right].normal);
  return n.dot(left) < sine && n.dot(right) < sine;
}

}  // namespace

double AsideOf(const PointContact& contact, const SolidPair& solids, const Transform& X_FM) {
  const auto& [moving, fixed, moving_f, fixed_f] = solids;
  switch (contact.kind) {
    case PointContactKind::kVertexFace:
      return FromFace(*fixed, fixed_f, contact.fixed, X_FM * moving_f.vertices[contact.moving]);
    case PointContactKind::kFaceVertex:
      return FromFace(*moving, moving_f, contact.moving, X_FM.Inverse() * fixed_f.vertices[contact.fixed]);
    default: {
      const Gap gap = GapOf(contact, moving_f, fixed_f, X_FM);
      const Vector3d n = gap.row.tail<3>().transpose();
      return std::max(BeyondEdge(moving_f.edges[contact.moving], X_FM.Inverse() * gap.at),
                      BeyondEdge(fixed_f.edges[contact.fixed], gap.at - gap.gap * n));
    }
  }
}

std::vector<PointContact> FindNearContacts(const SolidPair& solids, const Transform& X_FM,
                                           const NearContacts& limits) {
  const auto& [moving, fixed, moving_f, fixed_f] = solids;
  const double sine = std::sin(std::min(limits.angle, M_PI / 2));
  const Transform X_MF = X_FM.Inverse();
  std::vector<PointContact> near;
  const auto consider = [&](const PointContact& contact) {
    if (std::abs(GapOf(contact, moving_f, fixed_f, X_FM).gap) > limits.distance) return false;
    if (AsideOf(contact, solids, X_FM) > limits.distance) return false;
    near.push_back(contact);
    return true;
  };
  for (size_t v = 0; v < moving_f.vertices.size(); ++v) {
    for (size_t f = 0; f < fixed_f.faces.size(); ++f) {
      if (StandsOn(*moving, moving_f, v, X_MF.R * fixed_f.faces[f].normal, sine))
        consider({PointContactKind::kVertexFace, v, f});
    }
  }
  for (size_t f = 0; f < moving_f.faces.size(); ++f) {
    for (size_t v = 0; v < fixed_f.vertices.size(); ++v) {
      if (StandsOn(*fixed, fixed_f, v, X_FM.R * moving_f.faces[f].normal, sine))
        consider({PointContactKind::kFaceVertex, f, v});
    }
  }
  for (size_t e = 0; e < moving_f.edges.size(); ++e) {
    if (moving->edges[e].convexity != algebra::Convexity::kConvex) continue;
    const Vector3d along = (X_FM.R * (moving_f.edges[e].head - moving_f.edges[e].tail)).normalized();
    for (size_t g = 0; g < fixed_f.edges.size(); ++g) {
      if (fixed->edges[g].convexity != algebra::Convexity::kConvex) continue;
      const Vector3d cross = along.cross((fixed_f.edges[g].head - fixed_f.edges[g].tail).normalized());
      if (cross.norm() <= sine) continue;
      for (const int orientation : {1, -1}) {
        const Vector3d n = orientation * cross.normalized();
        if (IsNormalAt(*fixed, fixed_f, g, n, sine) &&
            IsNormalAt(*moving, moving_f, e, -(X_MF.R * n), sine) &&
            consider({PointContactKind::kEdgeEdge, e, g, orientation}))
          break;
      }
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace tact::recognition

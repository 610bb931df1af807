#include "robot/recognition/near_contacts.h"

#include <algorithm>
#include <cmath>

namespace tact::recognition {
namespace {

using Eigen::Vector3d;
using joint::Transform;

// How far beyond the ends of an edge a point of its line is.
double BeyondEdge(const SolidF::EdgeF& edge, const Vector3d& point) {
  const Vector3d along = edge.head - edge.tail;
  const double length = along.norm(), at = (point - edge.tail).dot(along) / length;
  return std::max({0.0, -at, at - length});
}

// Directions into the solid do not go below the plane by more than the angle.
template <class Directions>
bool StandsOn(const Directions& directions, const Vector3d& up, double sine) {
  return std::all_of(directions.begin(), directions.end(),
                     [&](const Vector3d& d) { return d.dot(up) >= -sine; });
}

class Finder {
 public:
  Finder(const ProximitySolid& moving, const ProximitySolid& fixed, const Transform& X_FM,
         const NearLimits& limits)
      : moving_(moving),
        fixed_(fixed),
        X_FM_(X_FM),
        X_MF_(X_FM.Inverse()),
        limits_(limits),
        sine_(std::sin(std::min(limits.angle, M_PI / 2))) {}

  std::vector<NearContact> Find() {
    AddVertices(moving_, fixed_, X_MF_.R, PointContactKind::kVertexFace);
    AddVertices(fixed_, moving_, X_FM_.R, PointContactKind::kFaceVertex);
    AddEdges();
    std::sort(near_.begin(), near_.end(),
              [](const NearContact& a, const NearContact& b) { return a.contact < b.contact; });
    return std::move(near_);
  }

 private:
  bool Consider(const PointContact& contact) {
    const double gap = GapOf(contact, moving_.solid(), fixed_.solid(), X_FM_).gap;
    if (std::abs(gap) > limits_.distance) return false;
    const double aside = AsideOf(contact, moving_, fixed_, X_FM_);
    if (aside > limits_.distance) return false;
    near_.push_back({contact, gap, aside});
    return true;
  }

  // R turns directions in the faces' solid into the vertices'.
  void AddVertices(const ProximitySolid& vertices, const ProximitySolid& faces, const Eigen::Matrix3d& R,
                   PointContactKind kind) {
    const bool is_moving = kind == PointContactKind::kVertexFace;
    for (size_t v = 0; v < vertices.solid().vertices.size(); ++v) {
      for (size_t f = 0; f < faces.solid().faces.size(); ++f) {
        if (StandsOn(vertices.edges_at(v), R * faces.solid().faces[f].normal, sine_))
          Consider({kind, is_moving ? v : f, is_moving ? f : v});
      }
    }
  }

  void AddEdges() {
    for (size_t e = 0; e < moving_.solid().edges.size(); ++e) {
      if (!moving_.is_convex(e)) continue;
      const auto& edge = moving_.solid().edges[e];
      const Vector3d along = (X_FM_.R * (edge.head - edge.tail)).normalized();
      for (size_t g = 0; g < fixed_.solid().edges.size(); ++g) {
        if (fixed_.is_convex(g)) AddCrossing(e, along, g);
      }
    }
  }

  void AddCrossing(size_t e, const Vector3d& along, size_t g) {
    const auto& edge = fixed_.solid().edges[g];
    const Vector3d cross = along.cross((edge.head - edge.tail).normalized());
    if (cross.norm() <= sine_) return;
    for (const int orientation : {1, -1}) {
      const Vector3d n = orientation * cross.normalized();
      if (StandsOn(fixed_.wings(g), -n, sine_) && StandsOn(moving_.wings(e), X_MF_.R * n, sine_) &&
          Consider({PointContactKind::kEdgeEdge, e, g, orientation}))
        return;
    }
  }

  const ProximitySolid &moving_, &fixed_;
  const Transform& X_FM_;
  Transform X_MF_;
  const NearLimits& limits_;
  double sine_;
  std::vector<NearContact> near_;
};

}  // namespace

double AsideOf(const PointContact& contact, const ProximitySolid& moving, const ProximitySolid& fixed,
               const Transform& X_FM) {
  switch (contact.kind) {
    case PointContactKind::kVertexFace:
      return fixed.AsideOfFace(contact.fixed, X_FM * moving.solid().vertices[contact.moving]);
    case PointContactKind::kFaceVertex:
      return moving.AsideOfFace(contact.moving, X_FM.Inverse() * fixed.solid().vertices[contact.fixed]);
    default: {
      const Gap gap = GapOf(contact, moving.solid(), fixed.solid(), X_FM);
      const Vector3d n = gap.row.tail<3>().transpose();
      return std::max(BeyondEdge(moving.solid().edges[contact.moving], X_FM.Inverse() * gap.at),
                      BeyondEdge(fixed.solid().edges[contact.fixed], gap.at - gap.gap * n));
    }
  }
}

std::vector<NearContact> FindNearContacts(const ProximitySolid& moving, const ProximitySolid& fixed,
                                          const Transform& X_FM, const NearLimits& limits) {
  return Finder(moving, fixed, X_FM, limits).Find();
}

}  // namespace tact::recognition

#include "robot/planning/over_approximation.h"

#include <algorithm>

namespace tact::planning {
namespace {

using algebra::Polyhedron;
using Eigen::Vector3d;
using recognition::PointContact;
using recognition::PointContactKind;

constexpr double kSameNormal = 1e-9;  // sine of the angle, and of that between edge and plane

bool IsEnd(const Polyhedron& solid, size_t edge, size_t vertex) {
  return solid.edges[edge].tail == vertex || solid.edges[edge].head == vertex;
}

// Whether all contacts lie along one edge of the moving or the fixed solid.
bool AllAlong(const Relation& relation, const Polyhedron& solid, size_t edge, bool of_moving) {
  const auto vertex_kind = of_moving ? PointContactKind::kVertexFace : PointContactKind::kFaceVertex;
  return std::all_of(relation.begin(), relation.end(), [&](const PointContact& contact) {
    const size_t element = of_moving ? contact.moving : contact.fixed;
    if (contact.kind == PointContactKind::kEdgeEdge) return element == edge;
    return contact.kind == vertex_kind && IsEnd(solid, edge, element);
  });
}

}  // namespace

LineContact LineContactOf(const Relation& relation, const Polyhedron& moving, const Polyhedron& fixed,
                          const recognition::SolidF& moving_f, const recognition::SolidF& fixed_f,
                          const joint::Transform& X_FM) {
  if (relation.size() < 2) return {};
  Vector3d n = Vector3d::Zero();
  for (const PointContact& contact : relation) {
    const Vector3d normal = GapOf(contact, moving_f, fixed_f, X_FM).row.tail<3>();
    if (n.isZero()) n = normal;
    if ((n - normal).norm() > kSameNormal) return {};
  }
  for (const bool of_moving : {true, false}) {
    const Polyhedron& solid = of_moving ? moving : fixed;
    const recognition::SolidF& solid_f = of_moving ? moving_f : fixed_f;
    for (size_t edge = 0; edge < solid.edges.size(); ++edge) {
      if (!AllAlong(relation, solid, edge, of_moving)) continue;
      const Vector3d along = (solid_f.edges[edge].head - solid_f.edges[edge].tail).normalized();
      const Vector3d l = of_moving ? Vector3d(X_FM.R * along) : along;
      if (std::abs(l.dot(n)) > kSameNormal) return {};
      return {of_moving ? LineContactKind::kEdgeFace : LineContactKind::kFaceEdge, l, n};
    }
  }
  return {};
}

const char* ToString(LineContactKind kind) {
  return kind == LineContactKind::kEdgeFace   ? "edge-face"
         : kind == LineContactKind::kFaceEdge ? "face-edge"
                                              : "";
}

}  // namespace tact::planning

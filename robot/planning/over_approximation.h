/// @file
/// Contacts of one edge with one face, whose first-order turns are more than the real ones [thesis, A.6].
/// Model   An edge l in a plane of normal n. To first order every axis in the span of l and n maintains the contact
///         (rank G = 1). Really, R l has to stay across n: a turn by a finite angle about a l + b n, a b != 0, takes n . R l
///         to a b (1 - cos angle), not zero. What does maintain it:
///         - moving edge on a fixed face: R(n, alpha) R(l, beta) (A.24), n fixed in F;
///         - moving face on a fixed edge: R(l, alpha) R(n, beta) (A.25), l fixed in F.
///         In general axes the first turn's is the one that the moving solid carries, the second's the one that stays.
///         (A.24) in the other order, R(l, beta) R(n, alpha) with l where it was at first, does not maintain it.
/// Frames  the fixed solid's.
#pragma once

#include "algebra/solid/polyhedron.h"
#include "robot/planning/motion_rows.h"

namespace tact::planning {

enum class LineContactKind { kNone, kEdgeFace, kFaceEdge };

struct LineContact {
  LineContactKind kind = LineContactKind::kNone;
  Eigen::Vector3d l{0, 0, 0}, n{0, 0, 0};  // unit, perpendicular to 1e-9

  explicit operator bool() const { return kind != LineContactKind::kNone; }
  /// The axis that the moving solid carries along, and the one that stays where it is.
  const Eigen::Vector3d& carried() const { return kind == LineContactKind::kEdgeFace ? l : n; }
  const Eigen::Vector3d& staying() const { return kind == LineContactKind::kEdgeFace ? n : l; }
};

/// Two point contacts or more with one normal, all along one edge of the moving solid (edge-face) or of the fixed one
/// (face-edge); an edge along an edge in one plane is the former.
LineContact LineContactOf(const Relation& relation, const algebra::Polyhedron& moving,
                          const algebra::Polyhedron& fixed, const recognition::SolidF& moving_f,
                          const recognition::SolidF& fixed_f, const joint::Transform& X_FM);

/// "edge-face", "face-edge"; "" for none.
const char* ToString(LineContactKind kind);

}  // namespace tact::planning

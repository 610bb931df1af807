/// @file
/// Gaps of elements and places of contacts along them, as functions of a pose in any kind of number.
/// Model   with x the posed moving point, f the fixed one: vertex-face n . (x - f); face-vertex - R n . (x - f), n the
///         moving face's; edge-edge +-(R e x g) . (x - f) / scale, whose zeros are those of the lines' distance. Along an
///         edge: the foot of the other line from one end, (d . g) - (d . R e) (R e . g), d from line to line, / scale.
///         Positive: apart, or within the edge.
/// Frames  the fixed solid's; a pose is its three columns and where the reference point is.
/// Units   the solids' length.
#pragma once

#include <Eigen/Core>
#include <array>

#include "robot/correction/jet.h"
#include "robot/joint/transform.h"

namespace tact::correction {

enum class FeatureKind { kVertexFace, kFaceVertex, kEdgeEdge, kAlongMoving, kAlongFixed };

struct Feature {
  FeatureKind kind = FeatureKind::kVertexFace;
  Eigen::Vector3d moving_point = Eigen::Vector3d::Zero();      // in M
  Eigen::Vector3d moving_direction = Eigen::Vector3d::Zero();  // in M; a face's normal or an edge's direction
  Eigen::Vector3d fixed_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d fixed_direction = Eigen::Vector3d::Zero();
  double factor = 1;  // sign / scale
};

template <class S>
struct Posed {
  std::array<Triple<S>, 3> columns;
  Triple<S> at;               // of the reference point
  Eigen::Vector3d reference;  // in M

  Triple<S> Rotate(const Eigen::Vector3d& u) const {
    const auto part = [&](auto member) {
      return columns[0].*member * u.x() + columns[1].*member * u.y() + columns[2].*member * u.z();
    };
    return {part(&Triple<S>::x), part(&Triple<S>::y), part(&Triple<S>::z)};
  }
  Triple<S> Point(const Eigen::Vector3d& p) const { return at + Rotate(p - reference); }
};

template <class S>
S ValueOf(const Feature& f, const Posed<S>& X) {
  const Triple<S> apart = X.Point(f.moving_point) - f.fixed_point;
  if (f.kind == FeatureKind::kVertexFace) return Dot(apart, f.fixed_direction) * f.factor;
  const Triple<S> along = X.Rotate(f.moving_direction);
  switch (f.kind) {
    case FeatureKind::kFaceVertex:
      return Dot(along, apart) * -f.factor;
    case FeatureKind::kEdgeEdge:
      return Dot(Cross(along, f.fixed_direction), apart) * f.factor;
    case FeatureKind::kAlongMoving:
      return (Dot(apart, along) - Dot(apart, f.fixed_direction) * Dot(along, f.fixed_direction)) * f.factor;
    default:
      return (Dot(apart, f.fixed_direction) - Dot(apart, along) * Dot(along, f.fixed_direction)) * -f.factor;
  }
}

// Compiled once.
extern template Jet<6> ValueOf(const Feature& f, const Posed<Jet<6>>& X);

/// A pose in doubles, and one with derivatives by [ w ; t ]: R <- exp(w) R, and t moves the reference point.
Posed<double> PosedAt(const joint::Transform& X_FM, const Eigen::Vector3d& reference);
Posed<Jet<6>> JetAt(const joint::Transform& X_FM, const Eigen::Vector3d& reference);

/// The pose after such a step.
joint::Transform Stepped(const joint::Transform& X_FM, const Eigen::Vector3d& reference,
                         const Eigen::Matrix<double, 6, 1>& step);

}  // namespace tact::correction

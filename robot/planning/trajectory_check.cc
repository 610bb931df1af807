#include "robot/planning/trajectory_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algebra/contact/contact_finder.h"

namespace tact::planning {
namespace {

using algebra::Rational;
using Eigen::Vector3d;
using joint::Transform;
using recognition::PointContact;
using recognition::PointContactKind;

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

Rational Exact(double value) { return Rational::FromShortestDecimal(value); }

double ToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d ab = b - a;
  const double s = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (p - a - s * ab).norm();
}

// A point of the face's plane in the solid's frame: 0 inside, else the distance from the boundary.
double OffFace(const algebra::Face& face, const recognition::SolidF& solid, const Vector3d& normal,
               const Vector3d& p) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  bool inside = false;
  double boundary = HUGE_VAL;
  for (const auto& loop : face.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3d &a = solid.vertices[loop[i]], &b = solid.vertices[loop[(i + 1) % loop.size()]];
      boundary = std::min(boundary, ToSegment(p, a, b));
      const double ya = v.dot(a - p), yb = v.dot(b - p);
      if ((ya > 0) == (yb > 0)) continue;
      const double xa = u.dot(a - p), xb = u.dot(b - p);
      if (xa - ya * (xb - xa) / (yb - ya) > 0) inside = !inside;
    }
  }
  return inside ? 0 : boundary;
}

double BeyondEnds(const recognition::SolidF::EdgeF& edge, const Vector3d& p) {
  const Vector3d along = edge.head - edge.tail;
  const double length = along.norm(), s = (p - edge.tail).dot(along) / length;
  return std::max({0.0, -s, s - length});
}

}  // namespace

algebra::Pose ExactPose(const Transform& X) {
  const Eigen::Quaterniond q(X.R);
  return {algebra::Rotation::FromQuaternion(Exact(q.w()), Exact(q.x()), Exact(q.y()), Exact(q.z())),
          {Exact(X.p.x()), Exact(X.p.y()), Exact(X.p.z())}};
}

double OverlapIn(const SolidPair& solids, const Transform& X_FM) {
  const auto overlap = FindPenetration(algebra::Transform(solids.moving, ExactPose(X_FM)), solids.fixed,
                                       Exact(kOverlapTolerance * solids.size));
  return overlap ? std::sqrt(ToDouble(overlap->squared_depth)) : 0;
}

double OffElements(const PointContact& contact, const SolidPair& solids, const Transform& X_FM) {
  const auto& [kind, m, f, orientation] = contact;
  if (kind == PointContactKind::kVertexFace)
    return OffFace(solids.fixed.faces[f], solids.fixed_f, solids.fixed_f.faces[f].normal,
                   X_FM * solids.moving_f.vertices[m]);
  if (kind == PointContactKind::kFaceVertex)
    return OffFace(solids.moving.faces[m], solids.moving_f, solids.moving_f.faces[m].normal,
                   X_FM.Inverse() * solids.fixed_f.vertices[f]);
  const Vector3d at = GapOf(contact, solids.moving_f, solids.fixed_f, X_FM).at;
  return std::max(BeyondEnds(solids.fixed_f.edges[f], at),
                  BeyondEnds(solids.moving_f.edges[m], X_FM.Inverse() * at));
}

TrajectoryCheck CheckTrajectory(const SolidPair& solids, const ContactState& start, const ContactState& end,
                                const Trajectory& trajectory) {
  TrajectoryCheck check;
  const size_t count = trajectory.samples.size();
  const auto fail = [&](size_t i, const std::string& what) {
    if (check.failure.empty())
      check.failure = what + ", sample " + std::to_string(i + 1) + " of " + std::to_string(count);
  };
  for (size_t i = 0; i < count; ++i) {
    const Sample& sample = trajectory.samples[i];
    const Relation& held = trajectory.inverse != sample.at_other ? end.relation : start.relation;
    for (const PointContact& contact : held) {
      const double off = OffElements(contact, solids, sample.X_FM);
      if (off > kOverlapTolerance * solids.size)
        fail(i, "a contact leaves its elements: " + ToString(contact) + " by " + Number(off));
    }
    check.overlaps.push_back(OverlapIn(solids, sample.X_FM));
    check.overlap = std::max(check.overlap, check.overlaps.back());
    if (check.overlaps.back() > 0) fail(i, "the solids overlap by " + Number(check.overlaps.back()));
  }
  return check;
}

}  // namespace tact::planning

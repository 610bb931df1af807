/// @file
/// The nearest pose that satisfies a contact relation without penetration.
/// Model   min d(X, X0)^2 = L^2 |log(R R0')|^2 + |p - p0|^2, p the place of the reference point, subject to contact_problem.h.
///         Sequential quadratic programming on the manifold of no gaps: steps with the exact Hessian of the Lagrangian,
///         each followed by a return to the manifold [Absil, Mahony and Sepulchre 2008; Nocedal and Wright 2006]. Of the
///         gaps an independent set is kept, chosen at the realisation. A pair of pieces is kept apart by the plane that
///         is widest open where the iteration stands; planes that tie are not tried apart. Starts: the pose seen and the
///         linear correction; the realisation, which is feasible, where both fail: so there is an answer wherever there is one.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame; the reference point is in M.
/// Units   the solids' length; radian.
/// Exact   no; a local optimum from each start, the best of them answered. tests and benchmarks hold it against Ipopt.
/// Cost    under 2 ms for solids of some ten pieces.
#pragma once

#include "robot/correction/contact_problem.h"

namespace tact::correction {

/// How far two poses are apart.
struct Metric {
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();
  /// L, how far a turn by a radian counts; 0: the models' size.
  double length = 0;
  /// Rotation first, and of the poses with the least of it the nearest: L is kFirst times the models' size. The turn then
  /// exceeds the least by some 1e-6 radian at most.
  bool rotation_first = false;

  double LengthFor(const Models& models) const;
};
inline constexpr double kFirst = 1e3;

struct Displacement {
  double rotation = 0, translation = 0;  // radian; of the reference point
  double Distance(double length) const { return std::hypot(length * rotation, translation); }
};
Displacement DisplacementBetween(const joint::Transform& X0, const joint::Transform& X,
                                 const Eigen::Vector3d& reference);

struct NearestPoseAnswer {
  joint::Transform X_FM;
  Outcome outcome = Outcome::kNoRealisation;
  double distance = 0;
  int iterations = 0;  // over all starts
};

/// Prepared once for a relation. Keeps references: models must outlive it.
class NearestPose {
 public:
  NearestPose(const Models& models, const Relation& relation, const Metric& metric = {});
  NearestPoseAnswer Find(const joint::Transform& X0) const;

  /// The gaps that the others follow from, near the realisation.
  const std::vector<Feature>& equalities() const { return equalities_; }

 private:
  struct Point;
  bool Return(joint::Transform& X, const std::vector<Feature>& on) const;
  bool LocalOptimum(const joint::Transform& X0, joint::Transform& X, int& iterations) const;
  Point At(const joint::Transform& X0, const joint::Transform& X) const;

  const Models& models_;
  Relation relation_;
  Metric metric_;
  double length_ = 0;
  std::vector<Feature> equalities_;
};

}  // namespace tact::correction

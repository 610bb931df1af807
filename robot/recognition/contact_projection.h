/// @file
/// The nearest pose at which given point contacts hold, penetration left aside: Gauss-Newton with smallest steps.
/// Model   The distance of two poses is the root mean square way of the moving solid's vertices: |u|^2 + w' J w to second
///         order, u the way of their centroid, w the turn, J the mean of |r|^2 I - r r'. Each step goes to the point nearest to the
///         start among those that satisfy the linearised contacts, by their pseudo-inverse in this metric.
/// Frames  F; X_FM is the moving solid's pose in it.
/// Units   the solids'.
/// Errors  none: what cannot hold together near the start does not converge.
/// Cost    some microseconds a step.
#pragma once

#include <optional>
#include <vector>

#include "robot/recognition/point_contact.h"

namespace tact::recognition {

/// How far poses of a solid are apart.
class PoseMetric {
 public:
  explicit PoseMetric(const SolidF& moving);

  /// Root mean square way of the vertices.
  double Distance(const joint::Transform& a, const joint::Transform& b) const;
  /// Root mean square distance of the vertices from their centroid.
  double radius() const { return radius_; }
  const Eigen::Vector3d& centroid() const { return centroid_; }
  /// The matrix whose product with a scaled turn, of the length of the way it makes, is the turn; in the solid's frame.
  const Eigen::Matrix3d& turn_of_way() const { return turn_of_way_; }
  const Eigen::Matrix3d& way_of_turn() const { return way_of_turn_; }

 private:
  Eigen::Vector3d centroid_;
  Eigen::Matrix3d turn_of_way_, way_of_turn_;
  double radius_ = 0;
};

struct Projection {
  joint::Transform X_FM;
  double displacement = 0;  // from the start
  int restricted = 0;       // DOFs that the contacts take: the rank of their rows
};

/// nullopt: no pose within farthest of the start satisfies them all to `exact`. guess: where the search begins.
std::optional<Projection> ProjectOntoContacts(const std::vector<PointContact>& contacts, const SolidF& moving,
                                              const SolidF& fixed, const PoseMetric& metric,
                                              const joint::Transform& start, const joint::Transform& guess,
                                              double farthest, double exact);

/// Contacts from the front of the list whose rows at a pose are independent, so many as their rank.
std::vector<PointContact> IndependentContacts(const std::vector<PointContact>& contacts, const SolidF& moving,
                                              const SolidF& fixed, const PoseMetric& metric,
                                              const joint::Transform& X_FM);

}  // namespace tact::recognition

/// @file
/// How far poses of a solid are apart: the root mean square way of its vertices.
/// Model   |u|^2 + w' J w to second order, u the way of their centroid, w the turn, J the mean of |r|^2 I - r r'.
/// Units   the solid's.
#pragma once

#include "robot/recognition/point_contact.h"

namespace tact::recognition {

class PoseMetric {
 public:
  explicit PoseMetric(const SolidF& moving);

  double Distance(const joint::Transform& a, const joint::Transform& b) const;
  /// Root mean square distance of the vertices from their centroid.
  double radius() const { return radius_; }
  const Eigen::Vector3d& centroid() const { return centroid_; }

 private:
  Eigen::Vector3d centroid_;
  Eigen::Matrix3d inertia_;  // J, in the solid's frame
  double radius_ = 0;
};

}  // namespace tact::recognition

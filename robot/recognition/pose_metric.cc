#include "robot/recognition/pose_metric.h"

#include <cmath>

namespace tact::recognition {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PoseMetric::PoseMetric(const SolidF& moving) : centroid_(Vector3d::Zero()), inertia_(Matrix3d::Zero()) {
  for (const Vector3d& p : moving.vertices) centroid_ += p;
  const auto count = static_cast<double>(moving.vertices.size());
  centroid_ /= count;
  for (const Vector3d& p : moving.vertices) {
    const Vector3d r = p - centroid_;
    inertia_ += (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose()) / count;
    radius_ += r.squaredNorm() / count;
  }
  radius_ = std::sqrt(radius_);
}

double PoseMetric::Distance(const joint::Transform& a, const joint::Transform& b) const {
  const Vector3d way = b * centroid_ - a * centroid_,
                 turn = b.R.transpose() * joint::RotationLog(b.R * a.R.transpose());
  return std::sqrt(way.squaredNorm() + turn.dot(inertia_ * turn));
}

}  // namespace tact::recognition

/// @file
/// The axis about which two parts turn, from a division of scans into them [thesis, 4.5.3, steps 4 and 5].
/// Model   relative poses of the second part A in the first part B, one a scan, go to maximum_likelihood.h.
///         The errors: each scan's points have the noise that surface.h measures; alignment makes errors of motions of it, the
///         first scan's shared by all others; the fit, linear in small errors, makes the axis' of these.
/// Frames  A and B are both the first scan's frame, moved to the centroid of its points: there errors of orientation and
///         location of an aligned part are nearly independent, as the likelihood takes them. The answer is in the first scan's
///         frame, in which the first part stands still.
/// Units   those of the points, radian.
#pragma once

#include "robot/joint/maximum_likelihood.h"
#include "robot/perception/part_division.h"

namespace tact::perception {

struct PartAxis {
  Vector3d point,
      direction;  // in the first scan's frame; the point is the axis' nearest to the second part's centroid
  std::vector<double>
      angles;  // of the second part in each scan; the first scan's is 0, most others are positive
  joint::JointFit fit;
  joint::Transform X_0B;  // B in the first scan's frame
  // Of the axis found against the true one, in any frame J with z along it and its origin at the point: J turned about x and
  // y, moved along x and y. frame: x, y and z of the J that is used.
  Eigen::Matrix4d covariance;
  Eigen::Matrix3d frame;
  double direction_error = 0;  // standard deviation of the angle to the true direction, root mean square
  double point_error = 0;      // and of the distance from the true axis at the point
};

/// Pre: the scans are divided.
PartAxis AxisOf(const Division& division, std::span<const Vector3d> first_scan);

/// How far the axis found is from the true one.
struct AxisError {
  double direction = 0;  // radian
  double point = 0;      // distance of the point from the true axis
  double squared = 0;  // e^T C^-1 e, C the covariance: chi squared with four degrees of freedom if C is right
};
AxisError ErrorOf(const PartAxis& axis, const Vector3d& true_point, const Vector3d& true_direction);

}  // namespace tact::perception

/// @file
/// What a person reads of an estimated joint: directions, points, lengths, in the frames of both links, each with its
/// covariance; corrected poses and residuals.
/// Model   Every parameter is a function of the set of poses that the joint allows, so it does not depend on how the
///         frame J is placed. Covariances come from the fit's by the derivative of that function.
///           direction    of the axis (planar: the plane's normal), in A and in B; two-axis: the first axis in B, the
///                        second in A
///           point        on the axis, in A: the one nearest to A's origin; in B: where that point lies when the joint
///                        is nearest to a reference pose (revolute: the centre about which A's origin turns, at any
///                        pose). spherical: the centre. two-axis: the feet of the common perpendicular, on the first
///                        axis in B, on the second in A. rigid, prismatic, planar: A's origin at the joint's pose
///                        nearest to the reference, in B
///           orientation  R_BA (rigid, prismatic), as a quaternion w, x, y, z with w >= 0
///           pitch        along the axis a radian;  offset between the axes, not negative
/// Sign    see joint_gauge.h: coordinates begin at zero and first reach far in the positive sense.
/// Units   metre, radian.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

enum class ParameterKind : std::uint8_t { kDirection, kPoint, kOrientation, kPitch, kLength };
enum class Link : std::uint8_t { kNeither, kA, kB };

struct NamedParameter {
  std::string_view name;  // direction, point, orientation, pitch, offset
  ParameterKind kind = ParameterKind::kPoint;
  Link frame = Link::kNeither;  // in which its numbers stand
  Eigen::Vector4d
      value;  // direction, point: x y z; orientation: w x y z; pitch, length: one number; the rest zero
  // Of the error's three components: a direction's lies across it, an orientation's is a rotation vector in B; pitch
  // and length fill one entry.
  Eigen::Matrix3d covariance;
  bool determined = false;  // false: the poses leave it open, and the covariance says nothing
  double expected_error =
      0;  // root mean square of the error's length: radian (direction, orientation), metre, metre a radian
};

/// reference: a pose among the data, say the first.
std::vector<NamedParameter> NamedParametersOf(const JointFit& fit, const Transform& reference);

/// How far a truth lies from the estimate: the squared error of all parameters together in units of their covariance,
/// to be compared with chi square of `freedom` degrees.
struct Distance {
  double squared = 0;
  int freedom = 0;
};
Distance DistanceTo(const Joint& truth, const JointFit& fit, const Transform& reference);

/// The poses the joint allows nearest to the observed ones, in their order.
std::vector<Transform> CorrectedPoses(const JointFit& fit);

/// What an observed pose lies off its corrected one.
struct Residual {
  Eigen::Vector3d rotation;     // rotation vector from the corrected orientation to the observed, in B
  Eigen::Vector3d translation;  // of A's origin, in B
};
std::vector<Residual> ResidualsOf(const JointFit& fit, std::span<const Transform> poses);

}  // namespace tact::joint

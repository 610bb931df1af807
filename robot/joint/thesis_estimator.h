/// @file
/// The thesis' own estimators, step by step as it writes them: the baseline to compare with.
/// Model   Orientations by conjugate gradients on angles, from the thesis' initial guesses [thesis, 4.5.1]; then, with
///         the orientations corrected, centre and pitch by linear least squares [eq. (4.18), (4.24)].
///           prismatic  (4.6) over roll, pitch, yaw, from the first pose's orientation; direction by principal
///           components revolute   (4.16) over two directions in spherical coordinates, from Method A's pair
///           screw      as revolute; the angles about the axis unwrapped along the poses' order (4.21)
///           two-axis   (4.38) over roll, pitch, yaw of both frames, from the identity; orientations only, no centre.
///         The thesis names neither the update nor the line search of its conjugate gradients, nor when they end:
///         CgOptions. Where its text is misprinted, what it must mean is done: (4.7) sums outer products, (4.21) takes
///         the angle with its sign, (4.26) has (-sin b, cos b sin c, cos b cos c) in its last row.
/// Units   metre, radian.
/// Pre     at least one pose; two for revolute and screw.
/// Errors  PreconditionError: another type.
/// Cost    O(N^2) for the pair of the initial guess, else O(N).
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "robot/joint/conjugate_gradient.h"
#include "robot/joint/joint.h"

namespace tact::joint {

/// The direction at inclination and azimuth [thesis, eq. (4.25)].
Eigen::Vector3d DirectionAt(double inclination, double azimuth);

/// Rz(a) Ry(b) Rx(c) of the angles (a, b, c) [thesis, eq. (4.26)], and back; b in [-pi/2, pi/2].
Eigen::Matrix3d RollPitchYaw(const Eigen::Vector3d& angles);
Eigen::Vector3d AnglesOf(const Eigen::Matrix3d& R);

/// One axis direction, as seen in either link.
struct AxisPair {
  Eigen::Vector3d l_A, l_B;
};

/// The two poses i < j between which the link turns by the angle nearest to a quarter turn. Pre: two poses.
std::pair<std::size_t, std::size_t> NearestQuarterTurn(std::span<const Transform> poses);

/// The axis about which the link turns from one pose to the other.
AxisPair AxisBetween(const Transform& from, const Transform& to);

/// Method A of 4.5.2: the axis between the poses of NearestQuarterTurn.
AxisPair MethodA(std::span<const Transform> poses);

/// The orientation nearest to R that takes l_A to l_B [thesis, 4.3.2].
Eigen::Matrix3d CorrectedOrientation(const Eigen::Matrix3d& R, const AxisPair& axes);

struct ThesisFit {
  Joint joint;
  double value = 0;  // of the sum that was minimized
  int iterations = 0;
  bool converged = false;
};

ThesisFit FitAsInThesis(JointType type, std::span<const Transform> poses, const CgOptions& options = {});

}  // namespace tact::joint

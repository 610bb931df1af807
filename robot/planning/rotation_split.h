/// @file
/// A rotation as a product of two about axes that are given, wholly or in part [thesis, (A.20)-(A.22), (A.24), (A.25)].
/// Model   D = Theta_e Theta_s^T turns the first orientation into the second, both in the fixed solid's frame. With unit
///         quaternions d = (w, v):
///         - about z and across: let w = cos, z . v = sin of half an angle twist/2, up to a common factor. Then D =
///           R(z, twist) R(m, swing) = R(m', swing) R(z, twist) with m, m' perpendicular to z and cos(swing / 2)
///           = sqrt(w^2 + (z . v)^2). Always possible; not unique where w = z . v = 0, when D is a half
///           turn about an axis across.
///         - about two axes, D = R(l, left) R(r, right): D r = R(l, left) r, so l . r = l . (D r) is needed, and with it
///           `left` is the angle from r to D r about l. (A.21) is of this kind and is NOT always satisfied, whatever
///           the thesis says: perpendicular l, r need l . (D r) = 0.
/// Units   radian; angles in (-pi, pi], the shorter way round.
#pragma once

#include <optional>

#include "robot/joint/transform.h"

namespace tact::planning {

/// A rotation about a unit axis.
struct Turn {
  Eigen::Vector3d axis{0, 0, 1};
  double angle = 0;

  Eigen::Matrix3d Rotation() const { return joint::RotationExp(angle * axis); }
};

/// Both orders with their own axis across.
struct AboutAndAcross {
  double about = 0;    // about z
  Turn across_first;   // D = R(z, about) * across_first
  Turn across_last;    // D = across_last * R(z, about)
  bool unique = true;  // false: any angle about z would do; it is 0
};

AboutAndAcross SplitAboutAndAcross(const Eigen::Matrix3d& D, const Eigen::Vector3d& z);

struct TwoTurns {
  Turn first, second;  // D = second * first
};

/// How far two axes are from having a solution that still counts as one, in the sine of the angle: 100 times what
/// rounding does, far below what anyone sees.
inline constexpr double kSplitTolerance = 1e-9;

/// Nothing if l . r differs from l . (D r) by more than kSplitTolerance. Axes that are parallel: all in `first`, if
/// they are D's.
std::optional<TwoTurns> SplitIntoTwo(const Eigen::Matrix3d& D, const Eigen::Vector3d& r /*first*/,
                                     const Eigen::Vector3d& l /*second*/);

/// The turn about z that brings u into the plane across n, z and n perpendicular, by the smaller of its two angles.
/// Always possible.
Turn TurnIntoPlane(const Eigen::Vector3d& u, const Eigen::Vector3d& n, const Eigen::Vector3d& z);

}  // namespace tact::planning

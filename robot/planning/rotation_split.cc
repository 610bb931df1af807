#include "robot/planning/rotation_split.h"

#include <cmath>
#include <numbers>

namespace tact::planning {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kNoTwist = 1e-12;  // of sqrt(w^2 + z^2): below, rounding decides the angle about z
constexpr double kNoTurn = 1e-15;   // of the sine of half an angle: below, rounding decides the axis

double Wrapped(double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  angle = std::remainder(angle, turn);
  return angle <= -std::numbers::pi ? angle + turn : angle;
}

// A turn about an axis across z; its part along z is rounding.
Turn AcrossFrom(Quaterniond q, const Vector3d& z) {
  if (q.w() < 0) q.coeffs() *= -1;
  const Vector3d v = q.vec() - z.dot(q.vec()) * z;
  const double norm = v.norm();
  if (norm < kNoTurn) return {z.unitOrthogonal(), 0};
  return {v / norm, 2 * std::atan2(norm, q.w())};
}

// From one vector to another about an axis.
double AngleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

}  // namespace

AboutAndAcross SplitAboutAndAcross(const Matrix3d& D, const Vector3d& z) {
  const Quaterniond d(D);
  const double along = d.vec().dot(z), length = std::hypot(d.w(), along);
  AboutAndAcross split;
  split.unique = length > kNoTwist;
  Quaterniond twist = Quaterniond::Identity();
  if (split.unique) {
    twist =
        Quaterniond(d.w() / length, along * z.x() / length, along * z.y() / length, along * z.z() / length);
    split.about = Wrapped(2 * std::atan2(along, d.w()));
  }
  split.across_first = AcrossFrom(twist.conjugate() * d, z);
  split.across_last = AcrossFrom(d * twist.conjugate(), z);
  return split;
}

std::optional<TwoTurns> SplitIntoTwo(const Matrix3d& D, const Vector3d& r, const Vector3d& l) {
  const Vector3d turned = D * r;
  if (std::abs(l.dot(r) - l.dot(turned)) > kSplitTolerance) return std::nullopt;
  const double left = r.cross(l).norm() < kSplitTolerance ? 0 : AngleAbout(l, r, turned);
  const Quaterniond rest(joint::RotationExp(-left * l) * D);
  const double right = Wrapped(2 * std::atan2(rest.vec().dot(r), rest.w()));
  return TwoTurns{{r, right}, {l, left}};
}

Turn TurnIntoPlane(const Vector3d& u, const Vector3d& n, const Vector3d& z) {
  // R(z, a) takes n to n cos a - l sin a and l to l cos a + n sin a; u's part along n is to become zero.
  const Vector3d l = n.cross(z);
  const double along_n = u.dot(n), along_l = u.dot(l);
  double angle = std::atan2(-along_n, along_l);
  if (angle > std::numbers::pi / 2) angle -= std::numbers::pi;
  if (angle < -std::numbers::pi / 2) angle += std::numbers::pi;
  if (along_n == 0) angle = 0;
  return {z, angle};
}

}  // namespace tact::planning

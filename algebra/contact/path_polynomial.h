/// @file
/// Points, planes and lines carried along a motion path, as polynomials of degree at most 2 in s.
/// Model   with u = p - c: w X(s) p = w c + u + 2 s a x u + s^2 (2 (a . u) a - |a|^2 u), w = 1 + s^2 |a|^2, for a
///         rotation; p + s d and w = 1 for a line. Backwards: -a or -d.
/// Exact   rational coefficients.
#pragma once

#include <array>

#include "algebra/contact/motion_path.h"
#include "algebra/solid/bounding_box.h"

namespace tact::algebra {

/// The same axis or direction, the other way: At(s) is the inverse.
MotionPath Backwards(const MotionPath& path);
/// w(s), positive.
Quadratic Weight(const MotionPath& path);
/// w(s) X(s) p.
std::array<Quadratic, 3> Carried(const MotionPath& path, const Vector3& point);
/// w(s) (n . X(s) p - offset).
Quadratic HeightAlong(const MotionPath& path, const Vector3& point, const Vector3& normal,
                      const Rational& offset);
/// w(s) times the reciprocal product of the line through p with direction d, carried, and the line through q
/// with direction e: zero where they meet or are parallel.
Quadratic MeetingAlong(const MotionPath& path, const Vector3& p, const Vector3& d, const Vector3& q,
                       const Vector3& e);
/// A box that surely holds X(s) p for all s in [0, 1]: that of the curve's control points.
BoundingBox SweptBox(const MotionPath& path, const Vector3& point);

}  // namespace tact::algebra

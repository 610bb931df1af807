#include "algebra/contact/path_polynomial.h"

namespace tact::algebra {
namespace {

Quadratic Combine(const Vector3& n, const std::array<Quadratic, 3>& v) {
  return n.x * v[0] + n.y * v[1] + n.z * v[2];
}

// w(s) R(s) v.
std::array<Quadratic, 3> Turned(const MotionPath& path, const Vector3& v) {
  std::array<Quadratic, 3> turned;
  const Vector3& a = path.vector;
  const bool turns = path.kind == MotionPath::Kind::kRotation;
  const Vector3 first = turns ? Rational(2) * Cross(a, v) : Vector3{};
  const Vector3 second = turns ? Rational(2) * Dot(a, v) * a - Dot(a, a) * v : Vector3{};
  for (int i = 0; i < 3; ++i) turned[i] = {v[i], first[i], second[i]};
  return turned;
}

}  // namespace

MotionPath Backwards(const MotionPath& path) { return {path.kind, -path.vector, path.center}; }

Quadratic Weight(const MotionPath& path) {
  if (path.kind == MotionPath::Kind::kLine) return {1, 0, 0};
  return {1, 0, Dot(path.vector, path.vector)};
}

std::array<Quadratic, 3> Carried(const MotionPath& path, const Vector3& point) {
  std::array<Quadratic, 3> carried = Turned(path, point - path.center);
  const Quadratic weight = Weight(path);
  for (int i = 0; i < 3; ++i) {
    carried[i] = carried[i] + path.center[i] * weight;
    if (path.kind == MotionPath::Kind::kLine) carried[i].c1 += path.vector[i];
  }
  return carried;
}

Quadratic HeightAlong(const MotionPath& path, const Vector3& point, const Vector3& normal,
                      const Rational& offset) {
  return Combine(normal, Carried(path, point)) - offset * Weight(path);
}

// About the center, the carried line has direction R d and moment R (u x d); a translation by s t adds
// s t x d to the moment.
Quadratic MeetingAlong(const MotionPath& path, const Vector3& p, const Vector3& d, const Vector3& q,
                       const Vector3& e) {
  const Vector3 moment = Cross(p - path.center, d), other = Cross(q - path.center, e);
  Quadratic product = Combine(other, Turned(path, d)) + Combine(e, Turned(path, moment));
  if (path.kind == MotionPath::Kind::kLine) product.c1 += Dot(e, Cross(path.vector, d));
  return product;
}

BoundingBox SweptBox(const MotionPath& path, const Vector3& point) {
  const auto weights = Weight(path).Bernstein();
  const auto carried = Carried(path, point);
  std::array<std::array<Rational, 3>, 3> control;
  for (int axis = 0; axis < 3; ++axis) control[axis] = carried[axis].Bernstein();
  BoundingBox box;
  for (int i = 0; i < 3; ++i) {
    box.Add(Vector3{control[0][i] / weights[i], control[1][i] / weights[i], control[2][i] / weights[i]});
  }
  return box;
}

}  // namespace tact::algebra

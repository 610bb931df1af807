#include "provers/check/path_geometry.h"

#include <cstddef>

namespace tact::check {
namespace {

// scale^2 (c0 + c1 s + c2 s^2) at s = (start + step t) / scale.
Polynomial AtStage(const Stage& stage, const mpz_class& c0, const mpz_class& c1, const mpz_class& c2) {
  const auto& [a, b, q] = stage;
  return Polynomial({c0 * q * q + c1 * q * a + c2 * a * a, c1 * q * b + 2 * c2 * a * b, c2 * b * b});
}

Row Scaled(const mpz_class& factor, const Row& v) { return {factor * v[0], factor * v[1], factor * v[2]}; }

// Of D^2 w R(s) v = D^2 v + 2 s D A x v + s^2 (2 (A . v) A - |A|^2 v), the coefficients of 1, s, s^2; the axis is
// A / D.
std::array<Row, 3> TurnCoefficients(const Row& axis, const Row& v) {
  const mpz_class &d = axis[3], square = Dot(axis, axis), along = 2 * Dot(axis, v);
  Row second(3);
  for (std::size_t i = 0; i < 3; ++i) second[i] = along * axis[i] - square * v[i];
  return {Scaled(d * d, v), Scaled(2 * d, Cross(axis, v)), second};
}

PolynomialPoint CarryAlong(const Path& path, const Row& p, const Stage& stage, int direction) {
  Row vector = path.vector;
  for (std::size_t i = 0; i < 3; ++i) vector[i] = direction * vector[i];
  const mpz_class& d = vector[3];
  PolynomialPoint carried;
  if (!path.turns) {
    for (std::size_t i = 0; i < 3; ++i) carried.xyz[i] = AtStage(stage, p[i] * d, vector[i] * p[3], 0);
    carried.w = AtStage(stage, p[3] * d, 0, 0);
    return carried;
  }
  // About the center c: p - c = u / (p's W times c's W).
  const Row u = Difference(p, path.point);
  const auto turned = TurnCoefficients(vector, u);
  const mpz_class square = Dot(vector, vector);
  for (std::size_t i = 0; i < 3; ++i) {
    const mpz_class center = path.point[i] * p[3];
    carried.xyz[i] =
        AtStage(stage, center * d * d + turned[0][i], turned[1][i], center * square + turned[2][i]);
  }
  const mpz_class w = p[3] * path.point[3];
  carried.w = AtStage(stage, w * d * d, 0, w * square);
  return carried;
}

Row ReadPoint(const Value& value) {
  Row point = AsIntegers(value, 4);
  if (point[3] <= 0) throw Refused(&value, "W is not positive");
  return point;
}

}  // namespace

Fraction ReadFraction(const Value& value) {
  const Row numbers = AsIntegers(value, 2);
  if (numbers[1] <= 0) throw Refused(&value, "the denominator is not positive");
  return {numbers[0], numbers[1]};
}

Stage Between(const Fraction& from, const Fraction& to) {
  return {from.p * to.q, to.p * from.q - from.p * to.q, from.q * to.q};
}

Stage Only(const Fraction& s) { return {s.p, 0, s.q}; }

PolynomialPoint Path::Carry(const Row& p, const Stage& stage) const { return CarryAlong(*this, p, stage, 1); }

PolynomialPoint Path::CarryBack(const Row& p, const Stage& stage) const {
  return CarryAlong(*this, p, stage, -1);
}

PolynomialVector Path::Turn(const Row& v, const Stage& stage) const {
  if (!turns) return Constant(v);
  const auto turned = TurnCoefficients(vector, v);
  PolynomialVector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = AtStage(stage, turned[0][i], turned[1][i], turned[2][i]);
  return result;
}

Path ReadPath(const Value& value) {
  Path path;
  ExpectKeys(value, {}, {"line", "rotation"});
  const Value* line = Find(value, "line");
  const Value* rotation = Find(value, "rotation");
  if ((line == nullptr) == (rotation == nullptr)) throw Refused(&value, "expected one line or one rotation");
  const Value* vector = line;
  if (rotation != nullptr) {
    ExpectKeys(*rotation, {"point", "axis"});
    path.turns = true;
    path.point = ReadPoint(At(*rotation, "point"));
    vector = &At(*rotation, "axis");
  }
  path.vector = ReadPoint(*vector);
  if (Dot(path.vector, path.vector) == 0) throw Refused(vector, "zero");
  return path;
}

PolynomialPoint Standing(const Row& point) { return {Constant(point), point[3]}; }

Row Difference(const Row& a, const Row& b) {
  Row difference(3);
  for (std::size_t i = 0; i < 3; ++i) difference[i] = a[i] * b[3] - b[i] * a[3];
  return difference;
}

PolynomialVector Difference(const PolynomialPoint& a, const PolynomialPoint& b) {
  PolynomialVector difference;
  for (std::size_t i = 0; i < 3; ++i) difference[i] = a.xyz[i] * b.w - b.xyz[i] * a.w;
  return difference;
}

Row Cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpz_class Dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace tact::check

/// @file
/// Exact three-vectors: points, directions, normals.
/// Exact   rational entries only.
#pragma once

#include <array>
#include <compare>
#include <string>

#include "algebra/exact/rational.h"

namespace tact::algebra {

struct Vector3 {
  Rational x, y, z;

  const Rational& operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
  Rational& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
  bool IsZero() const { return x.sign() == 0 && y.sign() == 0 && z.sign() == 0; }
  Vector3 operator-() const { return {-x, -y, -z}; }
  friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector3 operator*(const Rational& s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend bool operator==(const Vector3& a, const Vector3& b) = default;
  /// Lexicographic.
  friend std::strong_ordering operator<=>(const Vector3& a, const Vector3& b);
};

Rational Dot(const Vector3& a, const Vector3& b);
Vector3 Cross(const Vector3& a, const Vector3& b);
/// The positive multiple of a with integer entries without common factor; zero stays zero.
Vector3 Primitive(const Vector3& a);
/// a x b = 0.
bool Parallel(const Vector3& a, const Vector3& b);
/// "(x, y, z)", decimals where they are exact.
std::string ToString(const Vector3& a);
std::array<double, 3> ToDouble(const Vector3& a);

}  // namespace tact::algebra

#include "algebra/screw/vector3.h"

namespace tact::algebra {

std::strong_ordering operator<=>(const Vector3& a, const Vector3& b) {
  if (const auto order = a.x <=> b.x; order != 0) return order;
  if (const auto order = a.y <=> b.y; order != 0) return order;
  return a.z <=> b.z;
}

Rational Dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector3 Primitive(const Vector3& a) {
  if (a.IsZero()) return a;
  Integer common_denominator(1);
  for (int i = 0; i < 3; ++i) {
    const Integer& d = a[i].denominator();
    common_denominator *= DivideExactly(d, Gcd(common_denominator, d));
  }
  Integer common_factor(0);
  Vector3 scaled = Rational(common_denominator) * a;
  for (int i = 0; i < 3; ++i) common_factor = Gcd(common_factor, scaled[i].numerator());
  return Rational(Integer(1), common_factor) * scaled;
}

bool Parallel(const Vector3& a, const Vector3& b) { return Cross(a, b).IsZero(); }

std::string ToString(const Vector3& a) {
  return "(" + a.x.ToDecimal() + ", " + a.y.ToDecimal() + ", " + a.z.ToDecimal() + ")";
}

std::array<double, 3> ToDouble(const Vector3& a) { return {ToDouble(a.x), ToDouble(a.y), ToDouble(a.z)}; }

}  // namespace tact::algebra

/// @file
/// Exact numbers and points as the certificates write them. For certificate writers only.
#pragma once

#include <nlohmann/json.hpp>

#include "algebra/screw/vector3.h"

namespace tact::provers {

/// A JSON number up to 2^53, beyond that a string of digits.
inline nlohmann::ordered_json WholeJson(const algebra::Integer& value) {
  constexpr int64_t kLargestNumber = int64_t{1} << 53;
  if (value.is_small() && value.small() <= kLargestNumber && value.small() >= -kLargestNumber)
    return value.small();
  return value.ToString();
}

/// The least common denominator of a point's entries.
inline algebra::Integer CommonDenominator(const algebra::Vector3& p) {
  algebra::Integer w(1);
  for (int i = 0; i < 3; ++i) w *= DivideExactly(p[i].denominator(), Gcd(w, p[i].denominator()));
  return w;
}

/// [X,Y,Z,W], the point (X, Y, Z) / W with W > 0.
inline nlohmann::ordered_json PointJson(const algebra::Vector3& p) {
  const algebra::Integer w = CommonDenominator(p);
  const algebra::Vector3 scaled = algebra::Rational(w) * p;
  return nlohmann::ordered_json::array({WholeJson(scaled.x.numerator()), WholeJson(scaled.y.numerator()),
                                        WholeJson(scaled.z.numerator()), WholeJson(w)});
}

}  // namespace tact::provers

#include <cstdio>
#include <utility>

#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {

std::string DecimalText(const Rational& value) {
  constexpr size_t kMostDecimals = 20, kLongest = 24;
  Rational shifted = value;
  for (size_t decimals = 0; decimals <= kMostDecimals; ++decimals, shifted *= 10) {
    if (!shifted.is_integer()) continue;
    std::string digits = Abs(shifted).ToString();
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    if (decimals > 0) digits.insert(digits.size() - decimals, ".");
    return (value.sign() < 0 ? "-" : "") + digits;
  }
  const std::string ratio = value.ToString();
  return ratio.size() <= kLongest ? ratio : "about " + ApproximateText(ToDouble(value));
}

std::string ApproximateText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string PointText(const Vector3& point) {
  return "(" + DecimalText(point.x) + ", " + DecimalText(point.y) + ", " + DecimalText(point.z) + ")";
}

std::string PolygonText(size_t polygon) { return "face " + std::to_string(polygon + 1); }

void Refuse(std::string what, size_t polygon) { throw SoupError({std::move(what), polygon}); }

}  // namespace tact::algebra

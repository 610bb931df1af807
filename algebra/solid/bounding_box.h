/// @file
/// Boxes that surely hold exact points: for culling only, never for a decision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algebra/screw/vector3.h"

namespace tact::algebra {

struct BoundingBox {
  std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 3> high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  /// Grows by the point, rounded outward (ToDouble errs by one unit in the last place at most).
  void Add(const Vector3& point) {
    for (int i = 0; i < 3; ++i) {
      const double x = ToDouble(point[i]);
      const double slack =
          4 * std::numeric_limits<double>::epsilon() * std::abs(x) + std::numeric_limits<double>::min();
      low[i] = std::min(low[i], x - slack);
      high[i] = std::max(high[i], x + slack);
    }
  }
  void Add(const BoundingBox& other) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  /// At most the squared distance of the point to the box.
  double SquaredDistanceBelow(const Vector3& point) const {
    BoundingBox box;
    box.Add(point);
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double gap = std::max({0.0, low[i] - box.high[i], box.low[i] - high[i]});
      sum += gap * gap;
    }
    return sum * (1 - 1e-9);
  }
  /// Whether some point of this box is within the distance of some point of the other along every axis.
  bool Near(const BoundingBox& other, double distance) const {
    for (int i = 0; i < 3; ++i) {
      if (low[i] > other.high[i] + distance || other.low[i] > high[i] + distance) return false;
    }
    return true;
  }
};

}  // namespace tact::algebra

#include "algebra/solid/bounding_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tact::algebra {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ToDouble is right up to two units in the last place.
double Outwards(double value, double direction) {
  for (int i = 0; i < 4; ++i) value = std::nextafter(value, direction);
  return value;
}

}  // namespace

BoundingBox::BoundingBox() {
  low.fill(kInfinity);
  high.fill(-kInfinity);
}

void BoundingBox::Add(const Vector3& point) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const std::array<double, 3> rounded = ToDouble(point);
  for (size_t i = 0; i < 3; ++i) {
    const double x = std::clamp(rounded[i], -kMost, kMost);  // beyond the doubles it is infinite
    low[i] = std::min(low[i], Outwards(x, -kInfinity));
    high[i] = std::max(high[i], Outwards(x, kInfinity));
  }
}

void BoundingBox::Add(const BoundingBox& other) {
  for (size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

bool BoundingBox::Near(const BoundingBox& other, double distance) const {
  for (size_t i = 0; i < 3; ++i) {
    if (low[i] > other.high[i] + distance || other.low[i] > high[i] + distance) return false;
  }
  return true;
}

double BoundingBox::SquaredDistanceBelow(const BoundingBox& other) const {
  // Rounding a sum of three squares down by far more than it can err.
  constexpr double kSafety = 1 - 1e-9;
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const double gap = std::max({0.0, low[i] - other.high[i], other.low[i] - high[i]});
    sum += gap * gap;
  }
  return sum * kSafety;
}

BoundingBox BoxOf(const Vector3& point) {
  BoundingBox box;
  box.Add(point);
  return box;
}

BoundingBox BoxOf(const Polyhedron& solid) {
  BoundingBox box;
  for (const Vertex& v : solid.vertices) box.Add(v.point);
  return box;
}

std::vector<BoundingBox> FaceBoxes(const Polyhedron& solid) {
  std::vector<BoundingBox> boxes(solid.faces.size());
  for (size_t f = 0; f < solid.faces.size(); ++f) {
    for (const size_t v : solid.faces[f].loops[0]) boxes[f].Add(solid.vertices[v].point);
  }
  return boxes;
}

}  // namespace tact::algebra

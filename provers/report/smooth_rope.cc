#include "provers/report/smooth_rope.h"

#include <algorithm>
#include <cmath>

namespace tact::provers {
namespace {

using Point = LayoutPoint;

constexpr int kSamples = 5;          // of a cubic
constexpr double kGrid = 1LL << 30;  // steps of the grid across the drawing

Point Between(Point a, Point b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace

Point Cubic::At(double t) const {
  const Point a = Between(control[0], control[1], t), b = Between(control[1], control[2], t),
              c = Between(control[2], control[3], t);
  return Between(Between(a, b, t), Between(b, c, t), t);
}

Cubic Cubic::Part(double from, double to) const {
  // A polar form of the cubic: its control points are the values at (from, from, from), ..., (to, to, to).
  const auto value = [&](double r, double s, double t) {
    const Point a = Between(control[0], control[1], r), b = Between(control[1], control[2], r),
                c = Between(control[2], control[3], r);
    return Between(Between(a, b, s), Between(b, c, s), t);
  };
  return {{value(from, from, from), value(from, from, to), value(from, to, to), value(to, to, to)}};
}

double Cubic::length() const { return std::hypot(control[3].x - control[0].x, control[3].y - control[0].y); }

std::vector<Cubic> SmoothRope(const RopeLayout& layout, const std::vector<double>& bends) {
  const auto node = [&](size_t k) { return layout.nodes[static_cast<size_t>(layout.rope[k])]; };
  const size_t last = layout.rope.size() - 1;
  std::vector<Cubic> cubics;
  for (size_t k = 0; k < last; ++k) {
    const Point a = node(k), b = node(k + 1);
    const double third = std::hypot(b.x - a.x, b.y - a.y) / 3;
    const auto along = [&](size_t before, size_t after, double bend) {
      const double handle = bend * third;
      const Point from = node(before), to = node(after);
      const double length = std::max(std::hypot(to.x - from.x, to.y - from.y), 1e-300);
      return Point{handle * (to.x - from.x) / length, handle * (to.y - from.y) / length};
    };
    const Point at_a = along(k == 0 ? 0 : k - 1, k + 1, bends[k]),
                at_b = along(k, std::min(k + 2, last), bends[k + 1]);
    cubics.push_back({{a, {a.x + at_a.x, a.y + at_a.y}, {b.x - at_b.x, b.y - at_b.y}, b}});
  }
  return cubics;
}

knot::Curve PolylineOf(const std::vector<Cubic>& cubics, const RopeLayout& layout, const knot::PData& p) {
  double least = cubics[0].control[0].x, most = least;
  for (const LayoutPoint& point : layout.nodes) {
    least = std::min({least, point.x, point.y});
    most = std::max({most, point.x, point.y});
  }
  const double steps = kGrid / std::max(most - least, 1e-300);
  knot::Curve curve;
  const auto add = [&](Point point, long height) {
    curve.push_back({std::lround((point.x - least) * steps), std::lround((point.y - least) * steps), height});
  };
  std::vector<long> height(layout.rope.size(), 0);  // at each node
  for (size_t column = 0; column < layout.place.size(); ++column)
    height[static_cast<size_t>(layout.place[column])] = p.over(static_cast<int>(column) + 1) ? 1 : -1;
  add(cubics.front().control[0], 0);
  for (size_t k = 0; k < cubics.size(); ++k) {
    for (int i = 0; i < kSamples; ++i)
      add(cubics[k].At((i + 0.5) / kSamples), i == 0 ? height[k] : i + 1 == kSamples ? height[k + 1] : 0);
  }
  add(cubics.back().control[3], 0);
  return curve;
}

size_t CubicOf(int point, size_t cubics) {
  return std::min(static_cast<size_t>(std::max(0, point - 2) / kSamples), cubics - 1);
}

}  // namespace tact::provers

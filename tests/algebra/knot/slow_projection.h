/// @file
/// A knot projection by the slow obvious way, with other arithmetic than curve_projection.h: the rope is turned until the
/// view is the z axis, and each pair of edges is solved as two linear equations in rationals.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "algebra/knot/curve_projection.h"
#include "algebra/screw/pose.h"

namespace tact::knot {

struct SlowProjection {
  std::optional<CurveFaultKind> fault;
  PData p;
};

inline SlowProjection ProjectSlowly(const Curve& curve, const algebra::Rotation& turned) {
  using algebra::Rational;
  using algebra::Vector3;
  using Kind = CurveFaultKind;
  SlowProjection result;
  const auto blame = [&](Kind kind) {
    if (!result.fault || kind < *result.fault) result.fault = kind;
  };
  std::vector<Vector3> points;
  for (const Vector3& point : curve) points.push_back(turned * point);
  const size_t n = points.size();
  if (n < 2) return {Kind::kTooFewPoints, {}};
  for (size_t i = 1; i < n; ++i)
    if (points[i] == points[i - 1]) return {Kind::kRepeatedPoint, {}};
  if (points.front() == points.back()) return {Kind::kClosed, {}};
  for (size_t i = 1; i < n; ++i)
    if (points[i].x == points[i - 1].x && points[i].y == points[i - 1].y) return {Kind::kVerticalEdge, {}};
  struct Met {
    size_t edge;
    Rational at, height;
    Vector3 direction, place;
    size_t number;
  };
  std::vector<Met> met;
  for (size_t i = 0; i + 1 < n; ++i) {
    for (size_t j = i + 1; j + 1 < n; ++j) {
      const Vector3 a = points[i], d = points[i + 1] - a, b = points[j], e = points[j + 1] - b;
      const Rational det = e.x * d.y - d.x * e.y;
      if (det.sign() != 0) {
        if (j == i + 1) continue;
        // a + s d = b + t e in x and y, by Cramer's rule.
        const Rational s = (e.x * (b.y - a.y) - e.y * (b.x - a.x)) / det,
                       t = (d.x * (b.y - a.y) - d.y * (b.x - a.x)) / det;
        if (s < 0 || s > 1 || t < 0 || t > 1) continue;
        const Vector3 on_first = a + s * d, on_second = b + t * e;
        if (on_first == on_second) {
          blame(Kind::kMeetsItself);
        } else if (s == 0 || s == 1 || t == 0 || t == 1) {
          blame(Kind::kPointOnEdge);
        } else {
          const size_t number = met.size() / 2;
          met.push_back({i, s, on_first.z, d, {on_first.x, on_first.y, 0}, number});
          met.push_back({j, t, on_second.z, e, {on_first.x, on_first.y, 0}, number});
        }
        continue;
      }
      // Parallel: on one line? Then both as intervals of the coordinate that changes.
      if ((d.x * (b.y - a.y) - d.y * (b.x - a.x)).sign() != 0) continue;
      const auto along = [&](const Vector3& point) { return d.x.sign() != 0 ? point.x : point.y; };
      const auto height = [&](const Vector3& from, const Vector3& step, const Rational& u) {
        return from.z + (u - along(from)) / along(step) * step.z;
      };
      const Rational low = std::max(std::min(along(a), along(a + d)), std::min(along(b), along(b + e))),
                     high = std::min(std::max(along(a), along(a + d)), std::max(along(b), along(b + e)));
      if (low > high || (j == i + 1 && low == high)) continue;
      const int gap_low = (height(a, d, low) - height(b, e, low)).sign(),
                gap_high = (height(a, d, high) - height(b, e, high)).sign();
      const bool meets = j == i + 1 ? gap_low == gap_high : gap_low * gap_high <= 0;
      blame(meets ? Kind::kMeetsItself : low == high ? Kind::kPointOnEdge : Kind::kOverlap);
    }
  }
  if (result.fault) return result;
  std::map<Vector3, int> through;
  for (const Met& m : met)
    if (++through[m.place] > 2) return {Kind::kTriplePoint, {}};
  std::sort(met.begin(), met.end(),
            [](const Met& a, const Met& b) { return std::tie(a.edge, a.at) < std::tie(b.edge, b.at); });
  std::vector<int> sigma, attr;
  for (const Met& m : met) {
    const auto mate = std::find_if(
        met.begin(), met.end(), [&](const Met& other) { return other.number == m.number && &other != &m; });
    sigma.push_back(static_cast<int>(mate - met.begin()) + 1);
    const bool over = m.height > mate->height;
    const Vector3 upper = over ? m.direction : mate->direction, lower = over ? mate->direction : m.direction;
    const bool plus = Cross(upper, lower).z.sign() > 0;  // [thesis, 5.1.2]: (l_over x l_under) . e_z
    attr.push_back(over ? (plus ? 3 : 1) : (plus ? 4 : 2));
  }
  result.p = PData(sigma, attr);
  return result;
}

}  // namespace tact::knot

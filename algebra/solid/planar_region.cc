#include "algebra/solid/planar_region.h"

#include <algorithm>

namespace tact::algebra {
namespace {

// Twice the signed area of the projected triangle.
Rational Area(Axes axes, const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b[axes.u] - a[axes.u]) * (c[axes.v] - a[axes.v]) -
         (b[axes.v] - a[axes.v]) * (c[axes.u] - a[axes.u]);
}

bool Between(const Rational& a, const Rational& b, const Rational& x) {
  return a <= b ? a <= x && x <= b : b <= x && x <= a;
}

// Of a point on the line ab.
bool OnSegment(Axes axes, const Vector3& a, const Vector3& b, const Vector3& p) {
  return Between(a[axes.u], b[axes.u], p[axes.u]) && Between(a[axes.v], b[axes.v], p[axes.v]);
}

bool InsideSegment(Axes axes, const Vector3& a, const Vector3& b, const Vector3& p) {
  return p != a && p != b && OnSegment(axes, a, b, p);
}

template <typename Visit>
void ForEachEdge(const PlanarRegion& region, const Visit& visit) {
  for (const auto& loop : region.loops) {
    for (size_t i = 0; i < loop.size(); ++i) visit(*loop[i], *loop[(i + 1) % loop.size()]);
  }
}

bool IsCorner(const PlanarRegion& region, const Vector3& point) {
  for (const auto& loop : region.loops) {
    for (const Vector3* corner : loop) {
      if (*corner == point) return true;
    }
  }
  return false;
}

std::optional<Vector3> UnsharedPointInPlane(const PlanarRegion& region, const Vector3& a, const Vector3& b) {
  bool is_boundary_edge = false;
  std::optional<Vector3> met;
  ForEachEdge(region, [&](const Vector3& c, const Vector3& d) {
    if (met) return;
    if ((c == a && d == b) || (c == b && d == a)) {
      is_boundary_edge = true;
    } else {
      met = UnsharedPoint(region.axes, a, b, c, d);
    }
  });
  if (met || is_boundary_edge) return met;
  // The open segment avoids the boundary: it is inside or outside as a whole.
  const Vector3 middle = Rational(1, 2) * (a + b);
  if (LocateInPlane(region, middle) == Side::kInside) return middle;
  return std::nullopt;
}

}  // namespace

Axes ProjectionAxes(const Vector3& normal) {
  const int dropped = normal.z.sign() != 0 ? 2 : (normal.y.sign() != 0 ? 1 : 0);
  const Axes axes{(dropped + 1) % 3, (dropped + 2) % 3};
  return normal[dropped].sign() > 0 ? axes : Axes{axes.v, axes.u};
}

int Orientation(Axes axes, const Vector3& a, const Vector3& b, const Vector3& c) {
  return Area(axes, a, b, c).sign();
}

Vector3 DoubleArea(const std::vector<const Vector3*>& loop) {
  Vector3 area;
  for (size_t i = 2; i < loop.size(); ++i) {
    area = area + Cross(*loop[i - 1] - *loop[0], *loop[i] - *loop[0]);
  }
  return area;
}

PlanarRegion RegionOf(const Polyhedron& solid, const Face& face) {
  PlanarRegion region{face.normal, face.offset, ProjectionAxes(face.normal), {}};
  for (const auto& loop : face.loops) {
    auto& corners = region.loops.emplace_back();
    for (const size_t v : loop) corners.push_back(&solid.vertices[v].point);
  }
  return region;
}

Rational SixfoldVolumeUnder(const PlanarRegion& region) {
  Rational volume;
  for (const auto& loop : region.loops) volume += Dot(*region.loops[0][0], DoubleArea(loop));
  return volume;
}

Side LocateInPlane(const PlanarRegion& region, const Vector3& point) {
  const int v = region.axes.v;
  bool on_boundary = false;
  bool inside = false;
  ForEachEdge(region, [&](const Vector3& a, const Vector3& b) {
    if (on_boundary) return;
    const bool a_below = a[v] <= point[v];
    const bool b_below = b[v] <= point[v];
    const bool straddles = a_below != b_below;
    // A level with the point must be looked at even where both ends count as below.
    if (!straddles && a[v] != point[v] && b[v] != point[v]) return;
    const int turn = Orientation(region.axes, a, b, point);
    if (turn == 0) {
      on_boundary = OnSegment(region.axes, a, b, point);
    } else if (straddles && (turn > 0) == a_below) {
      inside = !inside;
    }
  });
  return on_boundary ? Side::kOnBoundary : (inside ? Side::kInside : Side::kOutside);
}

std::optional<Vector3> UnsharedPoint(Axes axes, const Vector3& a, const Vector3& b, const Vector3& c,
                                     const Vector3& d) {
  const Rational at_a = Area(axes, c, d, a);
  const Rational at_b = Area(axes, c, d, b);
  if (at_a.sign() * at_b.sign() > 0) return std::nullopt;
  const int at_c = Orientation(axes, a, b, c);
  const int at_d = Orientation(axes, a, b, d);
  if (at_c * at_d < 0 && at_a.sign() * at_b.sign() < 0) return a + at_a / (at_a - at_b) * (b - a);
  if (at_c == 0 && InsideSegment(axes, a, b, c)) return c;
  if (at_d == 0 && InsideSegment(axes, a, b, d)) return d;
  if (at_a.sign() == 0 && InsideSegment(axes, c, d, a)) return a;
  if (at_b.sign() == 0 && InsideSegment(axes, c, d, b)) return b;
  return std::nullopt;
}

std::optional<Vector3> UnsharedPoint(const PlanarRegion& region, const Vector3& a, const Vector3& b) {
  const Rational at_a = region.Height(a);
  const Rational at_b = region.Height(b);
  const int product = at_a.sign() * at_b.sign();
  if (product > 0) return std::nullopt;
  if (product == 0 && at_a == at_b) return UnsharedPointInPlane(region, a, b);
  Vector3 met = at_a.sign() == 0 ? a : b;
  if (product == 0 && IsCorner(region, met)) return std::nullopt;
  if (product < 0) met = a + at_a / (at_a - at_b) * (b - a);
  if (LocateInPlane(region, met) == Side::kOutside) return std::nullopt;
  return met;
}

bool Meets(const PlanarRegion& region, const Vector3& a, const Vector3& b) {
  for (const Vector3* end : {&a, &b}) {
    if (region.Height(*end).sign() == 0 && LocateInPlane(region, *end) != Side::kOutside) return true;
  }
  return UnsharedPoint(region, a, b).has_value();
}

}  // namespace tact::algebra

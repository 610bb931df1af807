#include "algebra/solid/distance.h"

#include <algorithm>

namespace tact::algebra {
namespace {

Rational Clamp(const Rational& t) { return std::clamp(t, Rational(0), Rational(1)); }

SegmentPoint At(const Vector3& a, const Vector3& b, const Rational& t) { return {a + t * (b - a), t}; }

// The coordinate to leave out so that the plane with this normal projects one to one.
int DroppedAxis(const Vector3& normal) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (Abs(normal[i]) > Abs(normal[axis])) axis = i;
  }
  return axis;
}

}  // namespace

SegmentPoint NearestOnSegment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 d = b - a;
  return At(a, b, Clamp(Dot(p - a, d) / Dot(d, d)));
}

SegmentPair NearestOnSegments(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const Vector3 u = b - a, v = d - c, w = a - c;
  const Rational uu = Dot(u, u), uv = Dot(u, v), vv = Dot(v, v), uw = Dot(u, w), vw = Dot(v, w);
  const Rational s = Clamp((uv * vw - vv * uw) / (uu * vv - uv * uv));
  // The best point on the second segment for s, then the best on the first for that [Ericson 2005, 5.1.9].
  const Rational t = Clamp((s * uv + vw) / vv);
  return {At(a, b, Clamp((t * uv - uw) / uu)), At(c, d, t)};
}

Vector3 ProjectOntoPlane(const Vector3& p, const Face& face) {
  const Rational excess = Dot(face.normal, p) - face.offset;
  return p - (excess / Dot(face.normal, face.normal)) * face.normal;
}

bool FaceContains(const Polyhedron& solid, const Face& face, const Vector3& point) {
  const int dropped = DroppedAxis(face.normal);
  const int x = (dropped + 1) % 3, y = (dropped + 2) % 3;
  bool inside = false;
  for (const auto& loop : face.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3& a = solid.vertices[loop[i]].point;
      const Vector3& b = solid.vertices[loop[(i + 1) % loop.size()]].point;
      const Rational turn = (b[x] - a[x]) * (point[y] - a[y]) - (b[y] - a[y]) * (point[x] - a[x]);
      if (turn.sign() == 0 && Dot(point - a, point - b).sign() <= 0) return true;
      if ((a[y] > point[y]) == (b[y] > point[y])) continue;
      if ((turn.sign() > 0) == (b[y] > a[y])) inside = !inside;
    }
  }
  return inside;
}

Rational SquaredDistance(const Vector3& a, const Vector3& b) { return Dot(a - b, a - b); }

Rational SquaredDistanceToFace(const Polyhedron& solid, const Face& face, const Vector3& point) {
  const Vector3 foot = ProjectOntoPlane(point, face);
  if (FaceContains(solid, face, foot)) return SquaredDistance(point, foot);
  const Vector3& corner = solid.vertices[face.loops[0][0]].point;
  Rational least = SquaredDistance(point, corner);
  for (const auto& loop : face.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3& a = solid.vertices[loop[i]].point;
      const Vector3& b = solid.vertices[loop[(i + 1) % loop.size()]].point;
      least = std::min(least, SquaredDistance(point, NearestOnSegment(point, a, b).point));
    }
  }
  return least;
}

SurfaceDistance::SurfaceDistance(const Polyhedron& solid) : solid_(solid) {
  for (const Face& face : solid.faces) {
    boxes_.emplace_back();
    for (const size_t v : face.loops[0]) boxes_.back().Add(solid.vertices[v].point);
  }
}

Rational SurfaceDistance::Squared(const Vector3& point) const {
  // The face with the nearest box goes first; it rules most of the others out.
  std::vector<double> bounds;
  for (const BoundingBox& box : boxes_) bounds.push_back(box.SquaredDistanceBelow(point));
  const size_t first = static_cast<size_t>(std::min_element(bounds.begin(), bounds.end()) - bounds.begin());
  Rational least = SquaredDistanceToFace(solid_, solid_.faces[first], point);
  for (size_t f = 0; f < bounds.size(); ++f) {
    if (f == first || bounds[f] > ToDouble(least) * (1 + 1e-9)) continue;
    const Rational d = SquaredDistanceToFace(solid_, solid_.faces[f], point);
    if (d < least) least = d;
  }
  return least;
}

}  // namespace tact::algebra

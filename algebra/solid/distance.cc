#include "algebra/solid/distance.h"

#include <algorithm>

#include "algebra/solid/planar_region.h"

namespace tact::algebra {
namespace {

Rational Clamp(const Rational& t) { return std::clamp(t, Rational(0), Rational(1)); }

SegmentPoint At(const Vector3& a, const Vector3& b, const Rational& t) { return {a + t * (b - a), t}; }

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
  return LocateInPlane(RegionOf(solid, face), point) != Side::kOutside;
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

}  // namespace tact::algebra

// Where a point lies: winding number along a ray, and the faces around the point if it is on some.
#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/solid/distance.h"
#include "algebra/solid/point_locator.h"
#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {
namespace {

// Whether the ray from the point towards +x leaves or enters through the face: the normal's x sign, or 0.
// The point counts as moved by (0, e, e^2...) with e -> 0, so the ray meets no edge; precondition: the
// point is not on the face.
int Crossing(const Polyhedron& solid, const Face& face, const Vector3& point) {
  const int direction = face.normal.x.sign();
  if (direction == 0) return 0;
  bool inside = false;
  for (const auto& loop : face.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3& a = solid.vertices[loop[i]].point;
      const Vector3& b = solid.vertices[loop[(i + 1) % loop.size()]].point;
      const bool a_below = a.z <= point.z;
      if (a_below == (b.z <= point.z)) continue;
      const int turn = Orientation({1, 2}, a, b, point);
      if (turn != 0 && (turn > 0) == a_below) inside = !inside;
    }
  }
  if (!inside) return 0;
  const int height = (Dot(face.normal, point) - face.offset).sign();
  return height * direction < 0 ? direction : 0;
}

// A corner of a face at a point: the rays along its two edges, with the face between them, counter-clockwise
// from first to second about the face's normal. No rays: the point is inside the face.
struct Sector {
  const PlanarRegion* region;
  std::vector<Vector3> rays;
};

std::vector<Sector> SectorsAt(const PlanarRegion& region, const Vector3& point) {
  std::vector<Sector> sectors;
  for (const auto& loop : region.loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3& a = *loop[i];
      const Vector3& b = *loop[(i + 1) % loop.size()];
      const Vector3& before = *loop[(i + loop.size() - 1) % loop.size()];
      if (a == point) {
        sectors.push_back({&region, {b - a, before - a}});
      } else if (b != point && Orientation(region.axes, a, b, point) == 0 &&
                 Dot(a - point, b - point).sign() < 0) {
        sectors.push_back({&region, {b - a, a - b}});
      }
    }
  }
  if (sectors.empty()) sectors.push_back({&region, {}});
  return sectors;
}

// Whether turning counter-clockwise about the normal from a, b is met strictly before c.
bool MetBefore(const Vector3& normal, const Vector3& a, const Vector3& b, const Vector3& c) {
  const auto half = [&](const Vector3& d) {  // 0 along a, 1 before half a turn, 2 half a turn, 3 behind it
    const int side = Dot(normal, Cross(a, d)).sign();
    if (side != 0) return side > 0 ? 1 : 3;
    return Dot(a, d).sign() > 0 ? 0 : 2;
  };
  const int hb = half(b), hc = half(c);
  if (hb != hc) return hb < hc;
  return Dot(normal, Cross(b, c)).sign() > 0;
}

// Whether the directions just counter-clockwise of ray are in the sector.
bool HoldsBehind(const Sector& sector, const Vector3& normal, const Vector3& ray) {
  if (sector.rays.empty()) return true;
  const bool same_sense = Dot(normal, sector.region->normal).sign() > 0;
  const Vector3& first = sector.rays[same_sense ? 0 : 1];
  const Vector3& second = sector.rays[same_sense ? 1 : 0];
  return MetBefore(normal, first, ray, second);
}

// Bodies that touch cover the point from all sides if, in every plane, what one covers from one side is
// covered from the other side too.
bool IsCovered(const std::vector<Sector>& sectors) {
  for (const Sector& sector : sectors) {
    const Vector3& normal = sector.region->normal;
    std::vector<const Sector*> coplanar;
    std::vector<Vector3> rays;
    for (const Sector& other : sectors) {
      if (!Parallel(normal, other.region->normal)) continue;
      coplanar.push_back(&other);
      rays.insert(rays.end(), other.rays.begin(), other.rays.end());
    }
    if (rays.empty()) rays.emplace_back();  // all faces hold the point inside them: any ray will do
    for (const Vector3& ray : rays) {
      int balance = 0;
      for (const Sector* other : coplanar) {
        if (!HoldsBehind(*other, normal, ray)) continue;
        balance += Dot(normal, other->region->normal).sign();
      }
      if (balance != 0) return false;
    }
  }
  return true;
}

}  // namespace

int Winding(const Polyhedron& solid, const Vector3& point, const std::vector<bool>& counts) {
  int winding = 0;
  for (const Face& face : solid.faces) {
    if (counts[face.shell]) winding += Crossing(solid, face, point);
  }
  return winding;
}

PointLocator::PointLocator(const Polyhedron& solid) : solid_(solid), boxes_(FaceBoxes(solid)) {
  for (const Face& face : solid.faces) {
    std::array<double, 3> n = ToDouble(face.normal);
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& x : n) x /= length;
    planes_.push_back({n, ToDouble(face.offset) / length});
  }
}

// The larger of the distances to the face's box and to its plane, less what doubles may err.
double PointLocator::SquaredDistanceBelow(size_t face, const BoundingBox& here) const {
  constexpr double kError =
      1e-12;  // of the largest term; four products and divisions err by less than 1e-15 each
  const Plane& plane = planes_[face];
  double height = -plane.offset, largest = std::abs(plane.offset);
  for (size_t i = 0; i < 3; ++i) {
    const double term = plane.normal[i] * here.low[i];
    height += term;
    largest = std::max(largest, std::abs(here.low[i]));
  }
  const double distance = std::max(0.0, std::abs(height) - kError * largest);
  return std::max(here.SquaredDistanceBelow(boxes_[face]), distance * distance * (1 - 1e-9));
}

Side PointLocator::Locate(const Vector3& point) const {
  const BoundingBox here = BoxOf(point);
  BoundingBox ray = here;
  ray.high[0] = std::numeric_limits<double>::infinity();
  std::vector<PlanarRegion> holding;
  int winding = 0;
  for (size_t f = 0; f < boxes_.size(); ++f) {
    if (!ray.Overlaps(boxes_[f])) continue;
    const Face& face = solid_.faces[f];
    if (here.Overlaps(boxes_[f]) && Dot(face.normal, point) == face.offset) {
      PlanarRegion region = RegionOf(solid_, face);
      if (LocateInPlane(region, point) != Side::kOutside) holding.push_back(std::move(region));
    }
    if (holding.empty()) winding += Crossing(solid_, face, point);
  }
  if (holding.empty()) return winding > 0 ? Side::kInside : Side::kOutside;
  std::vector<Sector> sectors;
  for (const PlanarRegion& region : holding) {
    for (Sector& sector : SectorsAt(region, point)) sectors.push_back(std::move(sector));
  }
  return IsCovered(sectors) ? Side::kInside : Side::kOnBoundary;
}

Rational PointLocator::SquaredDistanceToSurface(const Vector3& point, const Rational& enough) const {
  // The face with the nearest box goes first; it rules most of the others out.
  const BoundingBox here = BoxOf(point);
  std::vector<double> bounds;
  for (size_t f = 0; f < boxes_.size(); ++f) bounds.push_back(SquaredDistanceBelow(f, here));
  const size_t first = static_cast<size_t>(std::min_element(bounds.begin(), bounds.end()) - bounds.begin());
  Rational least = SquaredDistanceToFace(solid_, solid_.faces[first], point);
  // Above any double that the exact value may round to.
  constexpr double kSafety = 1 + 1e-9;
  double limit = ToDouble(least) * kSafety;
  for (size_t f = 0; f < bounds.size() && least > enough; ++f) {
    if (f == first || bounds[f] > limit) continue;
    const Rational d = SquaredDistanceToFace(solid_, solid_.faces[f], point);
    if (d >= least) continue;
    least = d;
    limit = ToDouble(least) * kSafety;
  }
  return least;
}

Side Locate(const Polyhedron& solid, const Vector3& point) { return PointLocator(solid).Locate(point); }

}  // namespace tact::algebra

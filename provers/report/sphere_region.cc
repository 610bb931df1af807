#include "provers/report/sphere_region.h"

#include <algorithm>
#include <array>
#include <set>

#include "algebra/cone/cone.h"
#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::provers {
namespace {

using algebra::HalfspaceCone;
using algebra::IntegerMatrix;
using algebra::Rational;
using algebra::Vector3;

IntegerMatrix NormalsOf(const algebra::ContactRelation& relation) {
  std::vector<std::vector<Rational>> rows;
  for (const algebra::Contact& contact : relation.contacts) {
    if (contact.planes.size() != 1 || contact.planes.front().IsZero()) {
      throw PreconditionError(
          "LegalDirections: expected contacts with one plane whose normal is not zero, got " +
          std::to_string(contact.planes.size()) + " planes at " + ToString(contact.point));
    }
    const Vector3& n = contact.planes.front();
    rows.push_back({n.x, n.y, n.z});
  }
  return IntegerMatrix::FromRationalRows(rows, 3);
}

size_t LegalDimension(const IntegerMatrix& normals) {
  return Dimension(Generators(HalfspaceCone(normals)).cone);
}

size_t MaintainingDimension(const IntegerMatrix& normals) { return 3 - Rank(normals); }

// Toward the viewer, to the right, up.
std::array<Vector3, 3> AxesOf(const View& view) {
  const Projection refuses_useless_views(view);
  const auto exact = [](const std::array<double, 3>& v) {
    return Vector3{Rational::FromShortestDecimal(v[0]), Rational::FromShortestDecimal(v[1]),
                   Rational::FromShortestDecimal(v[2])};
  };
  const Vector3 toward = exact(view.toward_viewer), right = Cross(exact(view.up), toward);
  return {toward, right, Cross(toward, right)};
}

bool BothOnOneBorder(const IntegerMatrix& normals, const Vector3& a, const Vector3& b) {
  for (size_t i = 0; i < normals.rows; ++i) {
    const Vector3 n = {normals(i, 0), normals(i, 1), normals(i, 2)};
    if (Dot(n, a).sign() == 0 && Dot(n, b).sign() == 0) return true;
  }
  return false;
}

SphereSet Cut(const HalfspaceCone& directions, size_t dimension, const IntegerMatrix& normals,
              const std::array<Vector3, 3>& axes) {
  SphereSet set{dimension, {}};
  std::set<std::vector<Vector3>> seen;  // arcs and points between octants
  for (int octant = 0; dimension > 0 && octant < 8; ++octant) {
    std::vector<std::vector<Rational>> sides;
    for (int i = 0; i < 3; ++i) {
      const Vector3 side = (octant >> (2 - i)) % 2 == 0 ? axes[i] : -axes[i];
      sides.push_back({side.x, side.y, side.z});
    }
    HalfspaceCone cone = directions;
    cone.inequalities.AppendRows(IntegerMatrix::FromRationalRows(sides, 3));
    const algebra::GeneratorCone part = Generators(cone).cone;
    if (Dimension(part) < dimension) continue;
    SpherePiece piece{{}, {}, octant < 4};
    std::vector<Vector3>& corners = piece.corners;
    for (size_t i = 0; i < part.rays.rows; ++i) {
      corners.push_back({part.rays(i, 0), part.rays(i, 1), part.rays(i, 2)});
    }
    const Vector3 pivot = corners.front();
    std::sort(corners.begin() + 1, corners.end(),
              [&](const Vector3& a, const Vector3& b) { return Dot(pivot, Cross(a, b)).sign() > 0; });
    if (!seen.insert(corners).second) continue;
    for (size_t i = 0; i < corners.size(); ++i) {
      piece.border.push_back(BothOnOneBorder(normals, corners[i], corners[(i + 1) % corners.size()]));
    }
    set.pieces.push_back(std::move(piece));
  }
  return set;
}

}  // namespace

std::string NameOf(SphereRegion region) {
  constexpr std::array<const char*, 10> kNames = {
      "whole sphere", "hemisphere",          "lune",  "convex polygon", "great circle", "half circle",
      "arc",          "two opposite points", "point", "nothing"};
  return kNames.at(static_cast<size_t>(region));
}

SphereRegion LegalDirections(const algebra::ContactRelation& relation) {
  using enum SphereRegion;
  constexpr std::array<std::array<SphereRegion, 4>, 4> kByDimensions = {{
      {kNothing},
      {kPoint, kOppositePoints},
      {kArc, kHalfCircle, kGreatCircle},
      {kConvexPolygon, kLune, kHemisphere, kWholeSphere},
  }};
  const IntegerMatrix normals = NormalsOf(relation);
  return kByDimensions.at(LegalDimension(normals)).at(MaintainingDimension(normals));
}

SphereSets CutIntoPieces(const algebra::ContactRelation& relation, const View& view) {
  const IntegerMatrix normals = NormalsOf(relation);
  const std::array<Vector3, 3> axes = AxesOf(view);
  return {Cut(HalfspaceCone(normals), LegalDimension(normals), normals, axes),
          Cut(HalfspaceCone(IntegerMatrix(0, 3), normals), MaintainingDimension(normals), normals, axes)};
}

}  // namespace tact::provers

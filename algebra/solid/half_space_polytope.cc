#include "algebra/solid/half_space_polytope.h"

#include "algebra/cone/cone.h"
#include "algebra/error.h"
#include "algebra/solid/convex_hull.h"

namespace tact::algebra {

PolygonSoup HalfSpacePolytope(const std::vector<std::pair<Vector3, Rational>>& half_spaces) {
  std::vector<std::vector<Rational>> rows = {{0, 0, 0, 1}};
  for (const auto& [n, offset] : half_spaces) {
    if (n.IsZero()) throw PreconditionError("HalfSpacePolytope: expected normals that are not zero");
    rows.push_back({-n.x, -n.y, -n.z, offset});
  }
  const GeneratorCone cone = Generators(HalfspaceCone(IntegerMatrix::FromRationalRows(rows, 4))).cone;
  std::vector<Vector3> corners;
  for (size_t i = 0; i < cone.rays.rows; ++i) {
    const Integer& height = cone.rays(i, 3);
    if (height.sign() == 0) continue;
    corners.push_back({Rational(cone.rays(i, 0), height), Rational(cone.rays(i, 1), height),
                       Rational(cone.rays(i, 2), height)});
  }
  if (corners.empty()) {
    throw PreconditionError("HalfSpacePolytope: expected half-spaces with a common point, got none");
  }
  if (cone.lines.rows > 0 || corners.size() < cone.rays.rows) {
    throw PreconditionError("HalfSpacePolytope: expected a bounded intersection, got one that is not");
  }
  const size_t dimension = Dimension(cone) - 1;
  if (dimension < 3) {
    throw PreconditionError("HalfSpacePolytope: expected a solid intersection, got one of dimension " +
                            std::to_string(dimension));
  }
  return ConvexHull(corners);
}

}  // namespace tact::algebra

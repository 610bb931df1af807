#include "algebra/contact/scene.h"

#include "algebra/error.h"
#include "algebra/solid/convex_hull.h"

namespace tact::algebra {

Polyhedron UnionOfHulls(const std::vector<std::vector<Vector3>>& pieces) {
  if (pieces.empty()) throw PreconditionError("a solid needs a piece");
  PolygonSoup soup;
  for (const auto& piece : pieces) {
    const PolygonSoup hull = ConvexHull(piece);
    const size_t shift = soup.points.size();
    soup.points.insert(soup.points.end(), hull.points.begin(), hull.points.end());
    for (auto polygon : hull.polygons) {
      for (size_t& corner : polygon) corner += shift;
      soup.polygons.push_back(std::move(polygon));
    }
  }
  try {
    return BuildPolyhedron(soup);
  } catch (const SoupError& error) {
    throw PreconditionError(std::string("the pieces are no solid: ") + error.what());
  }
}

PathContacts FollowScene(const Scene& scene) {
  return FollowPath(UnionOfHulls(scene.moving_pieces), UnionOfHulls(scene.fixed_pieces), scene.path);
}

}  // namespace tact::algebra

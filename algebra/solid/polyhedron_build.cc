#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {

Polyhedron BuildPolyhedron(const PolygonSoup& soup) {
  const SoupMesh mesh = BuildSoupMesh(soup);
  RefuseSelfIntersections(mesh);
  MergedFaces merged = MergeFaces(mesh);
  RefuseBadShells(merged);
  return std::move(merged.solid);
}

}  // namespace tact::algebra

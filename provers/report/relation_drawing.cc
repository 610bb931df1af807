#include "provers/report/relation_drawing.h"

#include <algorithm>

#include "provers/report/solid_drawing.h"

namespace tact::provers {
namespace {

using algebra::Face;
using algebra::Polyhedron;

constexpr size_t kCavity = 1;  // the cage's shell, see relation_solids.h

bool Touches(const Face& face, const algebra::ContactRelation& relation) {
  return std::ranges::any_of(relation.contacts, [&](const algebra::Contact& contact) {
    return face.normal == contact.planes.front() && Dot(face.normal, contact.point) == face.offset;
  });
}

// The cavity's faces that do, or do not, touch the block, with the vertices and edges of all.
Polyhedron CavityFaces(const algebra::RelationSolids& solids, bool touching) {
  Polyhedron part = solids.fixed;
  std::erase_if(part.faces, [&](const Face& face) {
    return face.shell != kCavity || Touches(face, solids.relation) != touching;
  });
  return part;
}

}  // namespace

std::string DrawRelationSolids(const algebra::RelationSolids& solids, const View& view) {
  return DrawContactRelation({{CavityFaces(solids, false), Part::kOutline},
                              {CavityFaces(solids, true), Part::kWall},
                              {solids.moving, Part::kMoving}},
                             solids.relation, view);
}

}  // namespace tact::provers

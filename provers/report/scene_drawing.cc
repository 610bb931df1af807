#include "provers/report/scene_drawing.h"

namespace tact::provers {

std::string DrawScene(const algebra::Scene& scene, int s, const algebra::ContactRelation& relation,
                      const View& view) {
  const algebra::Polyhedron moving = algebra::UnionOfHulls(scene.moving_pieces);
  return DrawContactRelation({{algebra::UnionOfHulls(scene.fixed_pieces), Part::kFixed},
                              {Transform(moving, scene.path.At(1 - s)), Part::kOutline},
                              {Transform(moving, scene.path.At(s)), Part::kMoving}},
                             relation, view);
}

}  // namespace tact::provers

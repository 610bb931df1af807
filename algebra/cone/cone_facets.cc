#include "algebra/cone/cone.h"
#include "algebra/cone/cone_check.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::algebra {

HalfspaceCone Facets(const GeneratorCone& cone) {
  RequireRows("line", cone.lines, cone.ambient_dimension());
  RequireRows("ray", cone.rays, cone.ambient_dimension());
  ConeGenerators dual = Generators(HalfspaceCone(cone.rays, cone.lines));
  return {std::move(dual.cone.rays), std::move(dual.cone.lines)};
}

GeneratorCone Canonical(const GeneratorCone& cone) { return Generators(Facets(cone)).cone; }

size_t Dimension(const GeneratorCone& cone) {
  IntegerMatrix all = cone.lines;
  all.AppendRows(cone.rays);
  return Rank(all);
}

size_t LinealityDimension(const GeneratorCone& cone) {
  const HalfspaceCone facets = Facets(cone);
  IntegerMatrix all = facets.equalities;
  all.AppendRows(facets.inequalities);
  return cone.ambient_dimension() - Rank(all);
}

}  // namespace tact::algebra

#include "algebra/cone/cone.h"
#include "algebra/cone/cone_check.h"

namespace tact::algebra {
namespace {

// The named columns, without the rows that vanish there.
IntegerMatrix ProjectRows(const IntegerMatrix& rows, std::span<const size_t> coordinates) {
  const IntegerMatrix selected = SelectColumns(rows, coordinates);
  IntegerMatrix result(0, coordinates.size());
  for (size_t i = 0; i < selected.rows; ++i) {
    if (!selected.IsZeroRow(i)) result.AppendRow(selected.row(i));
  }
  return result;
}

}  // namespace

ConeForms Project(const GeneratorCone& cone, std::span<const size_t> coordinates) {
  RequireRows("line", cone.lines, cone.ambient_dimension());
  RequireRows("ray", cone.rays, cone.ambient_dimension());
  ConeForms result;
  result.facets = Facets({ProjectRows(cone.lines, coordinates), ProjectRows(cone.rays, coordinates)});
  result.generators = Generators(result.facets).cone;
  return result;
}

ConeForms Project(const HalfspaceCone& cone, std::span<const size_t> coordinates) {
  return Project(Generators(cone).cone, coordinates);
}

}  // namespace tact::algebra

#include "provers/claims/definitions.h"

#include <array>

#include "algebra/contact/contact_rows.h"
#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::provers {

using algebra::IntegerMatrix;

IntegerMatrix LegalRows(const algebra::ContactRelation& relation) {
  algebra::ContactRows rows;
  rows.Assign(relation);
  IntegerMatrix matrix;
  matrix.rows = rows.size();
  matrix.columns = 6;
  matrix.entries = rows.ToIntegers();
  return matrix;
}

namespace {

// Some columns of a matrix, zero rows left out.
IntegerMatrix Columns(const IntegerMatrix& matrix, size_t first, size_t count) {
  std::vector<algebra::IntegerVector> rows;
  for (size_t i = 0; i < matrix.rows; ++i) {
    algebra::IntegerVector part;
    bool zero = true;
    for (size_t j = first; j < first + count; ++j) {
      part.push_back(matrix.row(i)[j]);
      zero = zero && part.back().sign() == 0;
    }
    if (!zero) rows.push_back(std::move(part));
  }
  return IntegerMatrix::FromRows(rows, count);
}

}  // namespace

Definitions ByDefinition(const algebra::ContactRelation& relation) {
  if (relation.singular()) throw PreconditionError("the definitions are those of non-singular relations");
  using algebra::Generators;
  using algebra::HalfspaceCone;
  constexpr std::array<size_t, 3> kAngular = {0, 1, 2};
  const IntegerMatrix a = LegalRows(relation), n = Columns(a, 3, 3);
  const auto legal = Generators(HalfspaceCone(a)), translations = Generators(HalfspaceCone(n));
  const auto axes = Project(legal.cone, kAngular);
  Definitions d;
  d.maintaining_all = static_cast<int>(legal.lineality_dimension());
  d.maintaining_translation = static_cast<int>(translations.lineality_dimension());
  d.maintaining_rotation = static_cast<int>(Rank(Columns(legal.cone.lines, 0, 3)));
  d.legal_all = static_cast<int>(Dimension(legal.cone));
  d.legal_translation = static_cast<int>(Dimension(translations.cone));
  d.legal_rotation = static_cast<int>(Dimension(axes.generators));
  d.two_way_rotation = static_cast<int>(LinealityDimension(axes.generators));
  IntegerMatrix g = axes.facets.inequalities;
  g.entries.insert(g.entries.end(), axes.facets.equalities.entries.begin(),
                   axes.facets.equalities.entries.end());
  g.rows += axes.facets.equalities.rows;
  d.rank_g = static_cast<int>(Rank(g));
  return d;
}

}  // namespace tact::provers

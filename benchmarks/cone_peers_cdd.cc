// cddlib's headers have no include guards against C++, and need these two in this order.
// clang-format off
#include <cdd/setoper.h>
#include <cdd/cdd.h>
// clang-format on

#include <stdexcept>

#include "benchmarks/cone_peers.h"

namespace tact::benchmarks {
namespace {

// cddlib's constants live from the first use to the end of the program.
void InitialiseOnce() {
  static const bool done = (dd_set_global_constants(), true);
  (void)done;
}

}  // namespace

ConeSize SizeByCdd(const std::vector<int64_t>& rows) {
  InitialiseOnce();
  const auto count = static_cast<dd_rowrange>(rows.size() / 6);
  dd_MatrixPtr matrix = dd_CreateMatrix(count, 7);
  matrix->representation = dd_Inequality;
  matrix->numbtype = dd_Rational;
  for (dd_rowrange i = 0; i < count; ++i) {
    for (dd_colrange j = 0; j < 6; ++j)
      dd_set_si(matrix->matrix[i][j + 1], rows[static_cast<size_t>(6 * i + j)]);
  }
  dd_ErrorType error = dd_NoError;
  dd_PolyhedraPtr cone = dd_DDMatrix2Poly(matrix, &error);
  if (error != dd_NoError) throw std::runtime_error("cddlib refused a cone");
  dd_MatrixPtr generators = dd_CopyGenerators(cone);

  ConeSize size;
  size.lineality = static_cast<int>(set_card(generators->linset));
  // The first column tells a vertex from a ray; the apex adds nothing to the rank of the others.
  dd_rowset no_rows = nullptr, row_basis = nullptr;
  dd_colset first_column = nullptr, column_basis = nullptr;
  set_initialize(&no_rows, generators->rowsize);
  set_initialize(&first_column, generators->colsize);
  set_addelem(first_column, 1);
  size.dimension =
      static_cast<int>(dd_MatrixRank(generators, no_rows, first_column, &row_basis, &column_basis));
  for (set_type set : {no_rows, row_basis, first_column, column_basis}) set_free(set);

  dd_FreeMatrix(generators);
  dd_FreePolyhedra(cone);
  dd_FreeMatrix(matrix);
  return size;
}

}  // namespace tact::benchmarks

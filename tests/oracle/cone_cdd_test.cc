/// @file
/// Generators of random cones compared with cddlib's: lines and rays.
/// Model   cddlib reads rows [ b | A ] for b + A x >= 0; b is zero here, and the origin is its one vertex.
/// Exact   cddlib in its GMP rational form.
#include <cdd/setoper.h>
// setoper.h first: cdd.h needs it.
#include <cdd/cdd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "algebra/cone/cone.h"
#include "algebra/exact/linear_algebra.h"
#include "tests/oracle/random_cone.h"

namespace tact::oracle {
namespace {

using algebra::EchelonBasis;
using algebra::GeneratorCone;
using algebra::HalfspaceCone;
using algebra::Integer;
using algebra::IntegerMatrix;
using algebra::IntegerVector;
using algebra::Rational;

void SetRow(dd_MatrixPtr matrix, size_t row, std::span<const Integer> entries) {
  for (size_t j = 0; j < entries.size(); ++j) entries[j].GetMpz(mpq_numref(matrix->matrix[row][j + 1]));
}

GeneratorCone GeneratorsByCdd(const HalfspaceCone& cone) {
  const size_t columns = cone.ambient_dimension();
  const size_t inequalities = cone.inequalities.rows;
  const size_t rows = inequalities + cone.equalities.rows;
  dd_MatrixPtr matrix =
      dd_CreateMatrix(static_cast<dd_rowrange>(rows), static_cast<dd_colrange>(columns + 1));
  matrix->representation = dd_Inequality;
  for (size_t i = 0; i < inequalities; ++i) SetRow(matrix, i, cone.inequalities.row(i));
  for (size_t i = inequalities; i < rows; ++i) {
    SetRow(matrix, i, cone.equalities.row(i - inequalities));
    set_addelem(matrix->linset, static_cast<long>(i + 1));
  }
  dd_ErrorType error = dd_NoError;
  dd_PolyhedraPtr polyhedron = dd_DDMatrix2Poly(matrix, &error);
  dd_FreeMatrix(matrix);
  if (error != dd_NoError) throw std::runtime_error("cddlib refuses a cone");
  dd_MatrixPtr generators = dd_CopyGenerators(polyhedron);
  GeneratorCone result{IntegerMatrix(0, columns), IntegerMatrix(0, columns)};
  for (dd_rowrange i = 0; i < generators->rowsize; ++i) {
    std::vector<Rational> entries;
    for (size_t j = 1; j <= columns; ++j) {
      mpq_srcptr entry = generators->matrix[i][j];
      entries.emplace_back(Integer::FromMpz(mpq_numref(entry)), Integer::FromMpz(mpq_denref(entry)));
    }
    const bool line = set_member(i + 1, generators->linset) != 0;
    const bool vertex = mpq_sgn(generators->matrix[i][0]) != 0;
    if (!vertex) (line ? result.lines : result.rays).AppendRow(algebra::Primitive(entries));
  }
  dd_FreeMatrix(generators);
  dd_FreePolyhedra(polyhedron);
  return result;
}

bool Agrees(const HalfspaceCone& cone) {
  const GeneratorCone found = algebra::Generators(cone).cone;
  const GeneratorCone expected = GeneratorsByCdd(cone);
  const EchelonBasis basis = algebra::RowSpace(expected.lines);
  IntegerMatrix rays(0, cone.ambient_dimension());
  for (size_t i = 0; i < expected.rays.rows; ++i) {
    rays.AppendRow(algebra::ReduceModulo(basis, expected.rays.row(i)));
  }
  return found.lines == basis.vectors && found.rays == SortedPrimitive(rays);
}

int Run(uint64_t cones, uint64_t seed) {
  uint64_t differences = 0;
  for (uint64_t index = 0; index < cones; ++index) {
    const HalfspaceCone cone = RandomCone(seed, index);
    if (cone.inequalities.rows + cone.equalities.rows == 0) continue;  // cddlib wants a row
    if (!Agrees(cone) && ++differences <= 5)
      std::cout << "cone " << index << " of seed " << seed << " differs\n";
  }
  std::cout << cones << " cones, " << differences << " differences\n";
  return differences == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::oracle

int main(int argc, char** argv) {
  dd_set_global_constants();
  int status = 2;
  try {
    uint64_t cones = 300, seed = 1;
    for (int i = 1; i < argc; i += 2) {
      const std::string name = argv[i];
      if ((name != "--cones" && name != "--seed") || i + 1 == argc) {
        throw std::invalid_argument("expected --cones N or --seed S, got " + name);
      }
      (name == "--cones" ? cones : seed) = std::stoull(argv[i + 1]);
    }
    status = tact::oracle::Run(cones, seed);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
  }
  dd_free_global_constants();
  return status;
}

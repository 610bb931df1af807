/// @file
/// Random cones for properties, degenerate ones on purpose.
#pragma once

#include "algebra/cone/cone.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {

/// Rows with entries -2 .. 2. One in three later rows is tied to the others: a copy times 2, an opposite, or
/// a sum. One matrix in eight has all its entries near 2^40, so that 64 bits do not do.
inline IntegerMatrix AnyConeRows(size_t rows, size_t columns) {
  IntegerMatrix a(rows, columns);
  const Integer unit = Uniform(0, 8) == 0 ? Integer((1LL << 40) - 87) : Integer(1);
  for (size_t i = 0; i < rows; ++i) {
    do {
      const int kind = i < 2 ? 0 : Uniform(0, 9);
      const size_t first = i == 0 ? 0 : Uniform<size_t>(0, i), second = i == 0 ? 0 : Uniform<size_t>(0, i);
      for (size_t j = 0; j < columns; ++j) {
        a(i, j) = kind == 6   ? a(first, j) * Integer(2)
                  : kind == 7 ? -a(first, j)
                  : kind == 8
                      ? a(first, j) + a(second, j)
                      : Integer(Uniform(-2, 3)) * unit + Integer(unit == Integer(1) ? 0 : Uniform(0, 9));
      }
    } while (a.IsZeroRow(i));
  }
  return a;
}

inline HalfspaceCone AnyHalfspaceCone(size_t most_rows, size_t least_columns, size_t most_columns) {
  const size_t columns = Uniform<size_t>(least_columns, most_columns + 1);
  const size_t equalities = Uniform(0, 4) == 0 ? 1 : 0;
  return {AnyConeRows(Uniform<size_t>(0, most_rows + 1), columns), AnyConeRows(equalities, columns)};
}

inline GeneratorCone AnyGeneratorCone(size_t most_rows, size_t least_columns, size_t most_columns) {
  const HalfspaceCone dual = AnyHalfspaceCone(most_rows, least_columns, most_columns);
  return {dual.equalities, dual.inequalities};
}

}  // namespace tact::algebra

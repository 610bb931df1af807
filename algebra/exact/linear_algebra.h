/// @file
/// Rank, null space, row space and solutions of linear systems, without fractions.
/// Model   Fraction-free Gauss-Jordan elimination: every intermediate entry is a minor of the matrix, each
///         division is exact [Bareiss 1968].
/// Exact   64-bit with overflow detection, GMP from the first overflow on; the answers never differ.
/// Errors  PreconditionError: shapes that do not match.
/// Cost    O(rows columns rank) operations; nothing is allocated inside the elimination while numbers fit in
///         64 bits.
#pragma once

#include <optional>
#include <vector>

#include "algebra/exact/integer_matrix.h"

namespace tact::algebra {

size_t Rank(const IntegerMatrix& a);
/// Of the named rows alone.
size_t RankOfRows(const IntegerMatrix& a, std::span<const size_t> rows);

/// A basis of { x | A x = 0 }, a vector a row. Canonical, it depends on that space alone: a vector for each
/// column that is a combination of earlier ones, primitive, positive there and zero at the other such
/// columns.
IntegerMatrix NullSpace(const IntegerMatrix& a);

/// The basis of the row space in reduced echelon form, each row primitive with a positive pivot. Canonical.
struct EchelonBasis {
  IntegerMatrix vectors;
  std::vector<size_t> pivots;  // the column of each row's first non-zero entry, increasing
};
EchelonBasis RowSpace(const IntegerMatrix& a);

/// The vector minus the combination of the basis that makes it zero at every pivot, primitive: the same for
/// all positive multiples of all vectors that differ by an element of the space.
IntegerVector ReduceModulo(const EchelonBasis& basis, std::span<const Integer> v);

/// Either x with A x = b, zero at the columns that are combinations of earlier ones, or y with y^T A = 0 and
/// y^T b != 0, which refutes that there is one.
struct LinearSolution {
  std::optional<std::vector<Rational>> x;
  IntegerVector refutation;  // empty if x is there
};
LinearSolution Solve(const IntegerMatrix& a, std::span<const Rational> b);

}  // namespace tact::algebra

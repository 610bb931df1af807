/// @file
/// Sparse systems of integers, solved exactly.
/// Model   SLIP_LU's fraction-free factorization with an ordering for symmetric patterns and diagonal pivots.
/// Exact   the solution, in lowest terms.
/// Errors  PreconditionError: a singular matrix, an entry out of place. InvariantError: the library fails otherwise.
/// Cost    of a planar graph's Laplacian with 60 rows 0.4 ms, 200 rows 4 ms; the numbers grow to some 0.7 digits a row.
/// Threads one call at a time; others wait.
#pragma once

#include <vector>

#include "algebra/exact/rational.h"

namespace tact::algebra {

struct SparseEntry {
  int row = 0, column = 0;  // from 0
  long value = 0;
};

/// The columns of X with A X = B; A is square with as many rows as B's columns have. Each place of A at most once.
std::vector<std::vector<Rational>> SolveSparse(const std::vector<SparseEntry>& a,
                                               const std::vector<std::vector<long>>& b_columns);

}  // namespace tact::algebra

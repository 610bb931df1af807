/// @file
/// Strictly complementary pairs: the evidence for a cone's dimension (docs/certificates.md).
/// Model   For the cone { x | A x >= 0 }: A x >= 0, y >= 0, y^T A = 0, and for each row exactly one of
///         (A x)_i, y_i is positive [Goldman and Tucker 1956]. Rows with y_i > 0 are the implicit equalities,
///         their rank the cone's codimension, x a point of its relative interior.
/// Shapes  A is m x n, row major, n <= 6, no zero row; x has n entries, y has m.
/// Exact   integers of any size.
/// Cost    one exact dual simplex run (dual_simplex.h), then O(m n) a step.
#pragma once

#include <vector>

#include "algebra/exact/integer.h"

namespace tact::algebra {

struct ComplementaryPair {
  std::vector<Integer> x;
  std::vector<Integer> y;
};

/// PreconditionError: a zero row (named), more than 6 columns, or a size that is no multiple of columns.
ComplementaryPair FindComplementaryPair(const std::vector<Integer>& rows, int columns);

}  // namespace tact::algebra

/// @file
/// Ranks of integer matrices.
/// Model   elimination without division: a row is reduced against each pivot row before it, v <- p v - v_c b,
/// where b is
///         the pivot row, p its pivot and c the pivot's column. Widths are at most 6, so entries grow at most
///         2^5-fold in length.
/// Exact   + * = only.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace tact::check {

using Row = std::vector<mpz_class>;
using Matrix = std::vector<Row>;

/// Rows of equal length; none has rank 0.
int Rank(const Matrix& matrix);

}  // namespace tact::check

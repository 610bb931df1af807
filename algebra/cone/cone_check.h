/// @file
/// The one precondition that the cone functions share; for the .cc files of cone.h.
#pragma once

#include <string>

#include "algebra/error.h"
#include "algebra/exact/integer_matrix.h"

namespace tact::algebra {

/// PreconditionError: a zero row, or not `columns` columns. `what` names a row in the message.
inline void RequireRows(const char* what, const IntegerMatrix& rows, size_t columns) {
  if (rows.columns != columns) {
    throw PreconditionError("a cone: expected every " + std::string(what) + " to have " +
                            std::to_string(columns) + " entries, got " + std::to_string(rows.columns));
  }
  for (size_t i = 0; i < rows.rows; ++i) {
    if (rows.IsZeroRow(i)) {
      throw PreconditionError("a cone: expected no zero row, got one: " + std::string(what) + " " +
                              std::to_string(i));
    }
  }
}

}  // namespace tact::algebra

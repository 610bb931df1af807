/// @file
/// Matrices of integers, row by row.
/// Shapes  rows x columns; entry (i, j) is entries[i * columns + j]. A matrix without rows still has columns.
/// Errors  PreconditionError: rows of unequal length, shapes that do not match; a message names the row.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "algebra/exact/integer.h"
#include "algebra/exact/rational.h"

namespace tact::algebra {

using IntegerVector = std::vector<Integer>;

struct IntegerMatrix {
  size_t rows = 0;
  size_t columns = 0;
  std::vector<Integer> entries;

  IntegerMatrix() = default;
  /// All zeros.
  IntegerMatrix(size_t row_count, size_t column_count)
      : rows(row_count), columns(column_count), entries(row_count * column_count) {}
  /// From rows of integers, as they are. PreconditionError: a row without `column_count` entries.
  static IntegerMatrix FromRows(const std::vector<IntegerVector>& rows, size_t column_count);
  /// From rows of rationals, each times the positive number that makes it primitive: integers without a
  /// common factor. A row of zeros stays one. PreconditionError: a row without `column_count` entries.
  static IntegerMatrix FromRationalRows(const std::vector<std::vector<Rational>>& rows, size_t column_count);
  static IntegerMatrix Identity(size_t n);

  const Integer& operator()(size_t i, size_t j) const { return entries[i * columns + j]; }
  Integer& operator()(size_t i, size_t j) { return entries[i * columns + j]; }
  std::span<const Integer> row(size_t i) const { return {entries.data() + i * columns, columns}; }
  IntegerVector RowVector(size_t i) const { return {row(i).begin(), row(i).end()}; }
  bool IsZeroRow(size_t i) const;
  /// PreconditionError: not `columns` entries.
  void AppendRow(std::span<const Integer> entries_of_row);
  /// PreconditionError: another number of columns.
  void AppendRows(const IntegerMatrix& other);

  friend bool operator==(const IntegerMatrix& a, const IntegerMatrix& b) = default;
};

IntegerMatrix Transpose(const IntegerMatrix& a);
/// The named rows, in the order named.
IntegerMatrix SelectRows(const IntegerMatrix& a, std::span<const size_t> rows);
/// The named columns, in the order named. PreconditionError: no such column.
IntegerMatrix SelectColumns(const IntegerMatrix& a, std::span<const size_t> columns);
/// PreconditionError: unequal lengths.
Integer Dot(std::span<const Integer> a, std::span<const Integer> b);
/// A x.
IntegerVector Multiply(const IntegerMatrix& a, std::span<const Integer> x);
/// The positive multiple with integer entries without common factor; zero stays zero.
IntegerVector Primitive(std::span<const Rational> v);
/// "(1, -2, 3)".
std::string ToString(std::span<const Integer> v);

}  // namespace tact::algebra

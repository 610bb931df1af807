#include "algebra/exact/integer_matrix.h"

#include "algebra/error.h"
#include "algebra/exact/word.h"

namespace tact::algebra {
namespace {

void RequireLength(size_t row, size_t expected, size_t got) {
  if (expected == got) return;
  throw PreconditionError("row " + std::to_string(row) + " of a matrix: expected " +
                          std::to_string(expected) + " entries, got " + std::to_string(got));
}

}  // namespace

IntegerMatrix IntegerMatrix::FromRows(const std::vector<IntegerVector>& rows, size_t column_count) {
  IntegerMatrix result(0, column_count);
  result.entries.reserve(rows.size() * column_count);
  for (const IntegerVector& row : rows) result.AppendRow(row);
  return result;
}

IntegerMatrix IntegerMatrix::FromRationalRows(const std::vector<std::vector<Rational>>& rows,
                                              size_t column_count) {
  IntegerMatrix result(0, column_count);
  result.entries.reserve(rows.size() * column_count);
  for (const std::vector<Rational>& row : rows) result.AppendRow(Primitive(row));
  return result;
}

IntegerMatrix IntegerMatrix::Identity(size_t n) {
  IntegerMatrix result(n, n);
  for (size_t i = 0; i < n; ++i) result(i, i) = 1;
  return result;
}

bool IntegerMatrix::IsZeroRow(size_t i) const {
  for (const Integer& entry : row(i)) {
    if (entry.sign() != 0) return false;
  }
  return true;
}

void IntegerMatrix::AppendRow(std::span<const Integer> entries_of_row) {
  RequireLength(rows, columns, entries_of_row.size());
  entries.insert(entries.end(), entries_of_row.begin(), entries_of_row.end());
  ++rows;
}

void IntegerMatrix::AppendRows(const IntegerMatrix& other) {
  RequireLength(rows, columns, other.columns);
  entries.insert(entries.end(), other.entries.begin(), other.entries.end());
  rows += other.rows;
}

IntegerMatrix Transpose(const IntegerMatrix& a) {
  IntegerMatrix result(a.columns, a.rows);
  for (size_t i = 0; i < a.rows; ++i) {
    for (size_t j = 0; j < a.columns; ++j) result(j, i) = a(i, j);
  }
  return result;
}

IntegerMatrix SelectRows(const IntegerMatrix& a, std::span<const size_t> rows) {
  IntegerMatrix result(0, a.columns);
  result.entries.reserve(rows.size() * a.columns);
  for (const size_t row : rows) result.AppendRow(a.row(row));
  return result;
}

IntegerMatrix SelectColumns(const IntegerMatrix& a, std::span<const size_t> columns) {
  IntegerMatrix result(a.rows, columns.size());
  for (size_t j = 0; j < columns.size(); ++j) {
    if (columns[j] >= a.columns) {
      throw PreconditionError("expected a column below " + std::to_string(a.columns) + ", got " +
                              std::to_string(columns[j]));
    }
    for (size_t i = 0; i < a.rows; ++i) result(i, j) = a(i, columns[j]);
  }
  return result;
}

Integer Dot(std::span<const Integer> a, std::span<const Integer> b) {
  if (a.size() != b.size()) {
    throw PreconditionError("a product of vectors with " + std::to_string(a.size()) + " and " +
                            std::to_string(b.size()) + " entries");
  }
  Integer sum;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

IntegerVector Multiply(const IntegerMatrix& a, std::span<const Integer> x) {
  IntegerVector result;
  result.reserve(a.rows);
  for (size_t i = 0; i < a.rows; ++i) result.push_back(Dot(a.row(i), x));
  return result;
}

IntegerVector Primitive(std::span<const Rational> v) {
  Integer multiple(1);
  for (const Rational& entry : v) {
    multiple *= DivideExactly(entry.denominator(), Gcd(multiple, entry.denominator()));
  }
  IntegerVector result;
  result.reserve(v.size());
  for (const Rational& entry : v) {
    result.push_back(entry.numerator() * DivideExactly(multiple, entry.denominator()));
  }
  MakePrimitive(result.data(), result.size());
  return result;
}

std::string ToString(std::span<const Integer> v) {
  std::string text = "(";
  for (size_t i = 0; i < v.size(); ++i) text += (i == 0 ? "" : ", ") + v[i].ToString();
  return text + ")";
}

}  // namespace tact::algebra

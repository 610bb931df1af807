#include "tests/oracle/random_cone.h"

#include <set>

#include "algebra/exact/word.h"
#include "tests/oracle/random_relation.h"

namespace tact::oracle {
namespace {

using algebra::HalfspaceCone;
using algebra::Integer;
using algebra::IntegerMatrix;
using algebra::IntegerVector;

IntegerVector ContactLikeRow(Random& random) {
  int p[3], n[3];
  for (int j = 0; j < 3; ++j) p[j] = random.Int(-2, 2);
  for (int j = 0; j < 3; ++j) n[j] = random.Int(-1, 1);
  return {p[1] * n[2] - p[2] * n[1], p[2] * n[0] - p[0] * n[2], p[0] * n[1] - p[1] * n[0], n[0], n[1], n[2]};
}

IntegerVector FreeRow(Random& random, size_t columns, int largest, bool huge) {
  IntegerVector row;
  for (size_t j = 0; j < columns; ++j) {
    row.emplace_back(random.Int(-largest, largest));
    if (huge) row.back() = row.back() * Integer(1LL << 40) + Integer(random.Int(-9, 9));
  }
  return row;
}

IntegerMatrix RandomRows(Random& random, size_t rows, size_t columns) {
  IntegerMatrix a(0, columns);
  const bool huge = random.OneIn(10);
  const bool contacts = columns == 6 && random.OneIn(2);
  const int largest = random.Int(1, 5);
  while (a.rows < rows) {
    IntegerVector row;
    const size_t first = a.rows == 0 ? 0 : random.Next() % a.rows;
    const size_t second = a.rows == 0 ? 0 : random.Next() % a.rows;
    const int kind = a.rows == 0 ? 0 : random.Int(0, 11);
    if (kind < 8) {
      row = contacts ? ContactLikeRow(random) : FreeRow(random, columns, largest, huge);
    } else {
      const Integer s(kind == 8 ? 2 : (kind == 9 ? -1 : 1)), t(kind == 10 ? 1 : (kind == 11 ? -1 : 0));
      for (size_t j = 0; j < columns; ++j) row.push_back(s * a(first, j) + t * a(second, j));
    }
    a.AppendRow(row);
    if (!a.IsZeroRow(a.rows - 1)) continue;
    a.entries.resize(--a.rows * columns);
  }
  return a;
}

}  // namespace

HalfspaceCone RandomCone(uint64_t seed, uint64_t index) {
  Random random(seed, index);
  const auto columns = static_cast<size_t>(random.Int(2, 7));
  const auto rows = static_cast<size_t>(random.Int(0, 14));
  IntegerMatrix inequalities = RandomRows(random, rows, columns);
  return {std::move(inequalities), RandomRows(random, random.OneIn(6) ? 1 : 0, columns)};
}

IntegerMatrix SortedPrimitive(const IntegerMatrix& rows) {
  std::set<IntegerVector> sorted;
  for (size_t i = 0; i < rows.rows; ++i) {
    IntegerVector row = rows.RowVector(i);
    algebra::MakePrimitive(row.data(), row.size());
    sorted.insert(std::move(row));
  }
  return IntegerMatrix::FromRows({sorted.begin(), sorted.end()}, rows.columns);
}

}  // namespace tact::oracle

#include "algebra/exact/linear_algebra.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algebra/error.h"
#include "algebra/exact/word.h"

namespace tact::algebra {
namespace {

// A matrix under elimination. After the k-th pivot, every entry is a minor of order k or k + 1 (forward) of
// the original; `pivot` is the last pivot.
template <typename Scalar>
struct Elimination {
  size_t rows, columns;
  std::vector<Scalar> entries;
  std::vector<size_t> pivot_columns;
  Scalar pivot{1};

  explicit Elimination(const IntegerMatrix& a) : rows(a.rows), columns(a.columns) {
    entries.reserve(a.entries.size());
    for (const Integer& entry : a.entries) entries.push_back(FromInteger<Scalar>(entry));
    pivot_columns.reserve(std::min(rows, columns));
  }

  const Scalar& at(size_t i, size_t j) const { return entries[i * columns + j]; }

  // kAbove also clears the entries above each pivot; all pivots then equal `pivot`.
  enum Extent { kBelow, kAbove };
  void Run(Extent extent) {
    for (size_t column = 0; column < columns && pivot_columns.size() < rows; ++column) {
      const size_t rank = pivot_columns.size();
      size_t found = rank;
      while (found < rows && at(found, column).sign() == 0) ++found;
      if (found == rows) continue;
      Scalar* source = &entries[rank * columns];
      if (found != rank) std::swap_ranges(source, source + columns, &entries[found * columns]);
      const Scalar next = source[column];
      for (size_t i = extent == kAbove ? 0 : rank + 1; i < rows; ++i) {
        if (i == rank) continue;
        Scalar* target = &entries[i * columns];
        const Scalar factor = target[column];
        // Rows above the pivot have entries left of the column that must grow with it.
        for (size_t j = i < rank ? 0 : column; j < columns; ++j) {
          target[j] = MultiplySubtractDivide(next, target[j], factor, source[j], pivot);
        }
      }
      pivot = next;
      pivot_columns.push_back(column);
    }
  }
};

template <typename Scalar>
Elimination<Scalar> Reduce(const IntegerMatrix& a) {
  Elimination<Scalar> work(a);
  work.Run(Elimination<Scalar>::kAbove);
  return work;
}

}  // namespace

size_t Rank(const IntegerMatrix& a) {
  return WordsFirst([&]<typename Scalar>(const Scalar&) {
    Elimination<Scalar> work(a);
    work.Run(Elimination<Scalar>::kBelow);
    return work.pivot_columns.size();
  });
}

size_t RankOfRows(const IntegerMatrix& a, std::span<const size_t> rows) { return Rank(SelectRows(a, rows)); }

IntegerMatrix NullSpace(const IntegerMatrix& a) {
  return WordsFirst([&]<typename Scalar>(const Scalar&) {
    const Elimination<Scalar> work = Reduce<Scalar>(a);
    IntegerMatrix basis(0, a.columns);
    for (size_t column = 0; column < a.columns; ++column) {
      if (std::binary_search(work.pivot_columns.begin(), work.pivot_columns.end(), column)) continue;
      IntegerVector v(a.columns);
      const bool flip = work.pivot.sign() < 0;
      v[column] = ToInteger(flip ? -work.pivot : work.pivot);
      for (size_t i = 0; i < work.pivot_columns.size(); ++i) {
        const Scalar& entry = work.at(i, column);
        v[work.pivot_columns[i]] = ToInteger(flip ? entry : -entry);
      }
      MakePrimitive(v.data(), v.size());
      basis.AppendRow(v);
    }
    return basis;
  });
}

EchelonBasis RowSpace(const IntegerMatrix& a) {
  return WordsFirst([&]<typename Scalar>(const Scalar&) {
    const Elimination<Scalar> work = Reduce<Scalar>(a);
    EchelonBasis basis{IntegerMatrix(0, a.columns), work.pivot_columns};
    const bool flip = work.pivot.sign() < 0;
    for (size_t i = 0; i < work.pivot_columns.size(); ++i) {
      IntegerVector v;
      for (size_t j = 0; j < a.columns; ++j) v.push_back(ToInteger(flip ? -work.at(i, j) : work.at(i, j)));
      MakePrimitive(v.data(), v.size());
      basis.vectors.AppendRow(v);
    }
    return basis;
  });
}

IntegerVector ReduceModulo(const EchelonBasis& basis, std::span<const Integer> v) {
  IntegerVector result(v.begin(), v.end());
  for (size_t i = 0; i < basis.pivots.size(); ++i) {
    const size_t pivot = basis.pivots[i];
    if (result[pivot].sign() == 0) continue;
    const Integer common = Gcd(result[pivot], basis.vectors(i, pivot));
    const Integer keep = DivideExactly(basis.vectors(i, pivot), common);
    const Integer take = DivideExactly(result[pivot], common);
    for (size_t j = 0; j < result.size(); ++j) result[j] = keep * result[j] - take * basis.vectors(i, j);
  }
  MakePrimitive(result.data(), result.size());
  return result;
}

LinearSolution Solve(const IntegerMatrix& a, std::span<const Rational> b) {
  if (b.size() != a.rows) {
    throw PreconditionError("a linear system of " + std::to_string(a.rows) + " equations with " +
                            std::to_string(b.size()) + " right-hand sides");
  }
  Integer denominator(1);
  for (const Rational& entry : b) {
    denominator *= DivideExactly(entry.denominator(), Gcd(denominator, entry.denominator()));
  }
  IntegerVector scaled;
  for (const Rational& entry : b) {
    scaled.push_back(entry.numerator() * DivideExactly(denominator, entry.denominator()));
  }
  IntegerMatrix augmented(0, a.columns + 1);
  for (size_t i = 0; i < a.rows; ++i) {
    IntegerVector row = a.RowVector(i);
    row.push_back(scaled[i]);
    augmented.AppendRow(row);
  }
  LinearSolution solution;
  solution.x = WordsFirst([&]<typename Scalar>(const Scalar&) -> std::optional<std::vector<Rational>> {
    const Elimination<Scalar> work = Reduce<Scalar>(augmented);
    if (!work.pivot_columns.empty() && work.pivot_columns.back() == a.columns) return std::nullopt;
    std::vector<Rational> x(a.columns);
    const Integer scale = ToInteger(work.pivot) * denominator;
    for (size_t i = 0; i < work.pivot_columns.size(); ++i) {
      x[work.pivot_columns[i]] = Rational(ToInteger(work.at(i, a.columns)), scale);
    }
    return x;
  });
  if (solution.x) return solution;
  const IntegerMatrix left_null = NullSpace(Transpose(a));
  for (size_t i = 0; i < left_null.rows; ++i) {
    if (Dot(left_null.row(i), scaled).sign() != 0) {
      solution.refutation = left_null.RowVector(i);
      return solution;
    }
  }
  throw InvariantError("an unsolvable linear system without a refutation");
}

}  // namespace tact::algebra

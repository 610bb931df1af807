#include "algebra/exact/sparse_solve.h"

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <mutex>

extern "C" {
#include <SLIP_LU.h>
}

#include "algebra/error.h"

namespace tact::algebra {
namespace {

void Check(SLIP_info info) {
  if (info == SLIP_OK) return;
  if (info == SLIP_SINGULAR)
    throw PreconditionError("SolveSparse: expected a regular matrix, got a singular one");
  throw InvariantError("SLIP_LU answers " + std::to_string(static_cast<int>(info)));
}

// SLIP_initialize gives the whole process an allocator for GMP that is slow and frees what is in use when it is taken away. So
// GMP's own is put back at once, and this happens while the program starts: no other thread can have met the wrong one.
const SLIP_info ready = [] {
  void* (*allocate)(size_t) = nullptr;
  void* (*reallocate)(void*, size_t, size_t) = nullptr;
  void (*release)(void*, size_t) = nullptr;
  mp_get_memory_functions(&allocate, &reallocate, &release);
  const SLIP_info info = SLIP_initialize();
  mp_set_memory_functions(allocate, reallocate, release);
  return info;
}();

// SLIP_LU keeps its place in a global variable.
std::mutex& SlipMutex() {
  static std::mutex mutex;
  return mutex;
}

class SlipMatrix {
 public:
  SlipMatrix() = default;
  SlipMatrix(SLIP_kind kind, int64_t rows, int64_t columns, int64_t entries) {
    Check(SLIP_matrix_allocate(&matrix_, kind, SLIP_MPZ, rows, columns, entries, false, true, nullptr));
  }
  ~SlipMatrix() { SLIP_matrix_free(&matrix_, nullptr); }
  SlipMatrix(const SlipMatrix&) = delete;
  SlipMatrix& operator=(const SlipMatrix&) = delete;

  SLIP_matrix* get() const { return matrix_; }
  SLIP_matrix** out() { return &matrix_; }

 private:
  SLIP_matrix* matrix_ = nullptr;
};

Rational FromMpq(mpq_srcptr value) {
  return Rational(Integer::FromMpz(mpq_numref(value)), Integer::FromMpz(mpq_denref(value)));
}

}  // namespace

std::vector<std::vector<Rational>> SolveSparse(const std::vector<SparseEntry>& a,
                                               const std::vector<std::vector<long>>& b_columns) {
  if (b_columns.empty() || b_columns.front().empty())
    return std::vector<std::vector<Rational>>(b_columns.size());
  const auto rows = static_cast<int64_t>(b_columns.front().size());
  std::vector<SparseEntry> entries = a;
  std::sort(entries.begin(), entries.end(), [](const SparseEntry& x, const SparseEntry& y) {
    return std::pair(x.column, x.row) < std::pair(y.column, y.row);
  });
  for (const SparseEntry& e : entries) {
    if (e.row < 0 || e.row >= rows || e.column < 0 || e.column >= rows)
      throw PreconditionError("SolveSparse: expected entries within " + std::to_string(rows) +
                              " rows and columns");
  }

  const std::lock_guard<std::mutex> lock(SlipMutex());
  Check(ready);
  const SlipMatrix matrix(SLIP_CSC, rows, rows, static_cast<int64_t>(entries.size()));
  SLIP_matrix* const csc = matrix.get();
  for (size_t k = 0; k < entries.size(); ++k) {
    csc->i[k] = entries[k].row;
    mpz_set_si(csc->x.mpz[k], entries[k].value);
    ++csc->p[entries[k].column + 1];
  }
  for (int64_t column = 0; column < rows; ++column) csc->p[column + 1] += csc->p[column];
  const SlipMatrix right(SLIP_DENSE, rows, static_cast<int64_t>(b_columns.size()), 0);
  for (size_t column = 0; column < b_columns.size(); ++column) {
    if (static_cast<int64_t>(b_columns[column].size()) != rows)
      throw PreconditionError("SolveSparse: expected columns of one length");
    for (size_t row = 0; row < b_columns[column].size(); ++row)
      mpz_set_si(right.get()->x.mpz[column * static_cast<size_t>(rows) + row], b_columns[column][row]);
  }
  SLIP_options options{};
  options.pivot = SLIP_DIAGONAL;
  options.order = SLIP_AMD;
  options.tol = 1;
  options.prec = 128;
  options.round = MPFR_RNDN;
  SlipMatrix solution;
  Check(SLIP_backslash(solution.out(), SLIP_MPQ, csc, right.get(), &options));
  std::vector<std::vector<Rational>> x(b_columns.size());
  for (size_t column = 0; column < x.size(); ++column) {
    for (int64_t row = 0; row < rows; ++row)
      x[column].push_back(FromMpq(solution.get()->x.mpq[static_cast<int64_t>(column) * rows + row]));
  }
  return x;
}

}  // namespace tact::algebra

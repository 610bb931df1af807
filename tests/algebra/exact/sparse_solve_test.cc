#include "algebra/exact/sparse_solve.h"

#include <gmp.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <future>
#include <random>

#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::algebra {
namespace {

struct System {
  std::vector<SparseEntry> entries;
  std::vector<long> b;
};

// The Laplacian of a random connected graph with one vertex tied to the ground, as Tutte's systems are: regular.
System RandomLaplacian(uint64_t seed, int rows) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<long>> a(static_cast<size_t>(rows),
                                   std::vector<long>(static_cast<size_t>(rows), 0));
  const auto join = [&](size_t i, size_t j) {
    if (i == j || a[i][j] != 0) return;
    a[i][j] = a[j][i] = -1;
    ++a[i][i];
    ++a[j][j];
  };
  for (size_t i = 1; i < a.size(); ++i) join(i, random() % i);
  for (size_t k = 0; k < a.size(); ++k) join(random() % a.size(), random() % a.size());
  ++a[0][0];
  System system;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const long value = a[static_cast<size_t>(i)][static_cast<size_t>(j)];
      if (value != 0) system.entries.push_back({i, j, value});
    }
    system.b.push_back(static_cast<long>(random() % 2001) - 1000);
  }
  return system;
}

std::vector<Rational> Times(const System& system, const std::vector<Rational>& x) {
  std::vector<Rational> product(x.size());
  for (const SparseEntry& e : system.entries)
    product[static_cast<size_t>(e.row)] += Rational(e.value) * x[static_cast<size_t>(e.column)];
  return product;
}

std::vector<Rational> AsRationals(const std::vector<long>& values) { return {values.begin(), values.end()}; }

RC_GTEST_PROP(SparseSolve, TheSolutionTimesTheMatrixIsTheRightSide, ()) {
  const System system = RandomLaplacian(*rc::gen::arbitrary<uint64_t>(), *rc::gen::inRange(1, 60));
  const auto x = SolveSparse(system.entries, {system.b, std::vector<long>(system.b.size(), 0)});
  RC_ASSERT(x.size() == 2u);
  RC_ASSERT(Times(system, x[0]) == AsRationals(system.b));
  RC_ASSERT(x[1] == std::vector<Rational>(system.b.size()));  // regular: only zero gives zero
}

RC_GTEST_PROP(SparseSolve, AgreesWithDenseElimination, ()) {
  const System system = RandomLaplacian(*rc::gen::arbitrary<uint64_t>(), *rc::gen::inRange(1, 12));
  const size_t rows = system.b.size();
  IntegerMatrix dense(rows, rows);
  for (const SparseEntry& e : system.entries)
    dense(static_cast<size_t>(e.row), static_cast<size_t>(e.column)) = Integer(e.value);
  const auto expected = Solve(dense, AsRationals(system.b));
  RC_ASSERT(expected.x.has_value());
  RC_ASSERT(SolveSparse(system.entries, {system.b})[0] == *expected.x);
}

// 2x + y = 1, x + 3y = 1, by hand; the entries in no order.
TEST(SparseSolve, FractionsComeInLowestTerms) {
  const auto x = SolveSparse({{1, 1, 3}, {0, 0, 2}, {1, 0, 1}, {0, 1, 1}}, {{1, 1}});
  EXPECT_EQ(x[0][0].ToString(), "2/5");
  EXPECT_EQ(x[0][1].ToString(), "1/5");
}

TEST(SparseSolve, NothingToSolveIsSolved) {
  EXPECT_TRUE(SolveSparse({}, {}).empty());
  EXPECT_EQ(SolveSparse({}, {{}, {}}).size(), 2u);
}

TEST(SparseSolve, SingularMatricesAndMisplacedEntriesAreRefused) {
  EXPECT_THROW(SolveSparse({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}, {{1, 1}}), PreconditionError);
  EXPECT_THROW(SolveSparse({{0, 1, 1}}, {{1}}), PreconditionError);
  EXPECT_THROW(SolveSparse({{-1, 0, 1}}, {{1}}), PreconditionError);
  EXPECT_THROW(SolveSparse({{0, 0, 1}}, {{1}, {1, 2}}), PreconditionError);
}

TEST(SparseSolve, GmpKeepsItsAllocator) {
  void* (*before)(size_t) = nullptr;
  void* (*after)(size_t) = nullptr;
  mp_get_memory_functions(&before, nullptr, nullptr);
  const System system = RandomLaplacian(1, 40);
  SolveSparse(system.entries, {system.b});
  mp_get_memory_functions(&after, nullptr, nullptr);
  EXPECT_EQ(before, after);
}

TEST(SparseSolve, ThreadsDoNotDisturbEachOther) {
  std::vector<std::future<bool>> solved;
  for (uint64_t seed = 0; seed < 4; ++seed) {
    solved.push_back(std::async(std::launch::async, [seed] {
      bool right = true;
      for (uint64_t k = 0; k < 10; ++k) {
        const System system = RandomLaplacian(100 * seed + k, 50);
        right &= Times(system, SolveSparse(system.entries, {system.b})[0]) == AsRationals(system.b);
      }
      return right;
    }));
  }
  for (auto& one : solved) EXPECT_TRUE(one.get());
}

}  // namespace
}  // namespace tact::algebra

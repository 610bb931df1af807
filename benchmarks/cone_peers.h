/// @file
/// What other tools say about a cone { x | A x >= 0 } in six dimensions; each in a file of its own because
/// their headers do not get along.
/// Shapes  six integers a row, row major.
/// Exact   GMP numbers in both.
#pragma once

#include <cstdint>
#include <vector>

namespace tact::benchmarks {

struct ConeSize {
  int dimension = 0;
  int lineality = 0;
  friend bool operator==(const ConeSize&, const ConeSize&) = default;
};

/// From the cone's generators, by PPL.
ConeSize SizeByPpl(const std::vector<int64_t>& rows);
/// From the cone's generators, by cddlib with GMP rationals.
ConeSize SizeByCdd(const std::vector<int64_t>& rows);

}  // namespace tact::benchmarks

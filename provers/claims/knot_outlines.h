/// @file
/// Outlines of ropes, and how far the claims of [thesis, 5.1] are tried on them.
/// Model   Knot graphs, faces and parts do not see which strand is above. An outline stands for all P-data with one
///         pairing and one choice of turns: every sign is minus, which makes it the least of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algebra/knot/p_data.h"
#include "provers/claims/knot_world.h"

namespace tact::provers {

/// In intersections.
inline int OutlineBound(Effort effort) {
  return effort == Effort::kQuick ? 5 : effort == Effort::kStandard ? 6 : 7;
}

/// Of a sphere with so many intersections, the least first.
const std::vector<knot::PData>& Outlines(int crossings);
/// Irreducible ones; of two mirror images the lesser.
const std::vector<knot::PData>& IrreducibleOutlines(int crossings);

/// The outline of p with all its heights and mirror images forgotten.
knot::PData OutlineOf(const knot::PData& p);
/// Outlines of the largest parts of random ropes of 6 to 12 intersections, two intersections at least.
std::vector<knot::PData> RandomIrreducibleOutlines(Effort effort);

/// A table's row.
inline std::vector<std::string> Row(const std::vector<long long>& numbers) {
  std::vector<std::string> row;
  for (const long long number : numbers) row.push_back(std::to_string(number));
  return row;
}

/// A statement tried on irreducible outlines and on random ones.
struct OutlineTrial {
  int least = 0, bound = 0;  // in intersections
  long long outlines = 0, random = 0, failures = 0;
  std::optional<knot::PData> first;  // failure, the least
};
/// Of outlines with `least` intersections or more.
OutlineTrial TryIrreducible(Effort effort, int least, const std::function<bool(const knot::PData&)>& holds);
/// "all irreducible P-data of 2 to 5 intersections, random ones of up to 12"
std::string BoundOf(const OutlineTrial& trial);
/// Holds to the bound, or refuted without a certificate.
Outcome Judge(const OutlineTrial& trial, const std::string& evidence);

}  // namespace tact::provers

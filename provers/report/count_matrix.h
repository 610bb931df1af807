/// @file
/// How often each of some things becomes each other, as a coloured matrix.
/// Model   Rows before, columns after. Shades are logarithmic, alike in all panels; a cell that was never met is hatched.
///         A marked cell has a thick border.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tact::provers {

struct CountPanel {
  std::string title;
  std::vector<std::vector<uint64_t>> counts;  // [before][after]; the diagonal is left out
};

/// One <svg> element without caption, for Figure. `marked`[before][after]; `legend` says what a mark means.
/// PreconditionError: counts or marks not as many as names.
std::string DrawCountMatrix(const std::vector<std::string>& names, const std::vector<CountPanel>& panels,
                            const std::vector<std::vector<bool>>& marked, const std::string& legend);

}  // namespace tact::provers

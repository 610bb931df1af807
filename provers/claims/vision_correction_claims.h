/// @file
/// The claims of [thesis, 2.7.3 and 2.8.3] about vision error correction, in two files.
#pragma once

#include <string>
#include <vector>

#include "provers/claims/printed_table.h"
#include "provers/ledger.h"

namespace tact::provers {

/// Table 2.1 itself.
std::vector<Claim> VisionCorrectionTableClaims();

/// "97.3 % (95.9 to 98.2)": a rate with its 95 % interval [Wilson 1927].
std::string WilsonText(size_t successes, size_t trials);

/// The mean with its interval, or that there is none.
std::string MeanText(const Moments& moments);

}  // namespace tact::provers

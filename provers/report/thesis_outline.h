/// @file
/// Where in the thesis a claim belongs, so that the report can follow the thesis' order.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// A place such as {"2", "2", "1"} for 2.2.1, {"A", "4"} for A.4; empty: not in the thesis.
using Place = std::vector<std::string>;

/// The section number that starts the claim's source ("2.2.1, Proposition 3", "Appendix A.4", "Chapter 5"),
/// else the one in its id ("thesis.5.3.2.r2-rule"), else none.
Place PlaceOf(const Claim& claim);

/// The order of the thesis: 1 ... 6, A ... C, each number as a number, and what has no place last.
bool ComesBefore(const Place& a, const Place& b);

/// "Chapter 6: Conclusions and future directions", "Appendix A: Sub-skill implementation", "Beyond the
/// thesis".
std::string ChapterTitle(const Place& place);

/// "2.2 Indexing infinitesimal displacement"; empty for a place that names a whole chapter or no place.
std::string SectionTitle(const Place& place);

}  // namespace tact::provers

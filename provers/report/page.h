/// @file
/// index.html: the ledger for people. One page without links to anything but its own certificates; XHTML
/// syntax.
#pragma once

#include <string>
#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// The page: what this is, how many claims got which verdict, the contents in the thesis' order, then each
/// claim with all its evidence. All text is escaped; drawings are taken as they are.
std::string ReportPage(const std::vector<LedgerEntry>& entries);

/// One claim's <article>, its statement a heading of that level.
std::string ClaimArticle(const LedgerEntry& entry, int heading_level);

/// The verdict as a coloured chip: a sign, the word, and a colour.
std::string VerdictChip(Verdict verdict);

/// The verdict as a name in the style sheet: "not-reproduced".
std::string VerdictStyle(Verdict verdict);

/// The page's style sheet and script.
extern const char* const kPageStyle;
extern const char* const kPageScript;

}  // namespace tact::provers

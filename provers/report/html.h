/// @file
/// Pieces of pages that the reports share: XHTML syntax, all text escaped, drawings taken as they are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "provers/ledger.h"

namespace tact::provers {

/// The whole page around its body: the style sheet is in it, and it links to nothing.
std::string PageHtml(std::string_view title, std::string_view body);

/// A table that scrolls if it must; columns of numbers are set right.
std::string TableHtml(const Table& table);

/// A drawing with its caption, whose id is given.
std::string FigureHtml(const Figure& figure, const std::string& id);

/// "1 claim", "12 345 claims".
std::string Plural(size_t count, const std::string& noun);

}  // namespace tact::provers

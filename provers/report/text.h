/// @file
/// Text made safe for HTML, SVG and XML, and numbers made readable.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tact::provers {

/// The text for element content and quoted attributes: & < > " ' escaped; bytes that are no UTF-8 and control
/// characters other than tab and line feed become U+FFFD, because XML has no way to write them.
std::string Escape(std::string_view text);

/// The same bytes where they are UTF-8, U+FFFD for the others.
std::string ValidUtf8(std::string_view text);

/// Thousands set apart by a narrow space: 1 234 567.
std::string GroupedDigits(long long value);

/// "under 1 ms", "20 ms", "1.3 s", "2 min 5 s", "1 h 2 min".
std::string ReadableSeconds(double seconds);

/// "512 bytes", "12 kB", "3.4 MB".
std::string ReadableSize(size_t bytes);

/// At most two decimals, no trailing zeros, never "-0".
std::string ShortDecimal(double value);

}  // namespace tact::provers

/// @file
/// Pieces of text that the answers share.
#pragma once

#include <string>

namespace tact::cli {

/// print(item) of each, with `between` between two.
template <typename List, typename Print>
std::string Join(const List& list, const char* between, const Print& print) {
  std::string text;
  bool first = true;
  for (const auto& item : list) {
    if (!first) text += between;
    first = false;
    text += print(item);
  }
  return text;
}

/// A field of a CSV line in quotes.
inline std::string CsvString(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace tact::cli

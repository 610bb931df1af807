/// @file
/// SVG to PNG by rsvg-convert (Debian's librsvg2-bin).
/// Errors  InputError: the program is missing or fails, the file cannot be written.
#pragma once

#include <filesystem>
#include <string>

namespace tact::cli {

/// On white; written aside, then renamed.
void WritePng(const std::filesystem::path& path, const std::string& svg);

}  // namespace tact::cli

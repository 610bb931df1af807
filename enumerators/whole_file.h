/// @file
/// Files that are whole or not there: written aside, flushed to the disk, renamed.
/// Errors  InputError: the file cannot be written (a full disk, a folder that is none); what stood there before stays.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tact::enumerators {

/// Writes `text` to `path` through a file in `aside`, a folder of the same file system.
void WriteWhole(const std::filesystem::path& path, const std::string& text,
                const std::filesystem::path& aside);

/// Whether WriteWhole made a file of that name on its way: such a file may be left by a run that was killed.
bool IsAside(const std::filesystem::path& path);

/// The file's bytes; none if it is not there. InputError: it cannot be read.
std::optional<std::string> ReadWhole(const std::filesystem::path& path);

/// Makes the folder and those above it. InputError: it cannot be made.
void MakeFolder(const std::filesystem::path& folder);

/// Sees to it that the names in the folder outlive a loss of power.
void FlushFolder(const std::filesystem::path& folder);

}  // namespace tact::enumerators

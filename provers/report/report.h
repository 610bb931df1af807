/// @file
/// The report that `tact verify` writes: a folder with index.html for people, ledger.json for programs and
/// certificates/ for `tact-check`.
/// Errors  InputError: the folder cannot be made, or something that is no report of ours stands in its place;
///         says what to do.
#pragma once

#include <filesystem>
#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// Throws the InputError that WriteReport would throw for what stands there now. Ask before a long run.
void CheckReportPlace(const std::filesystem::path& directory);

/// Writes the report into a folder beside `directory` and puts it in place in one step, so that an
/// interrupted run leaves what was there before. A folder that is there is replaced only if it is empty or
/// holds a report of ours and nothing else. Precondition: entries as TryClaims returns them.
void WriteReport(const std::vector<LedgerEntry>& entries, const std::filesystem::path& directory);

}  // namespace tact::provers

/// @file
/// ledger.json: the ledger for programs.
/// Model   {"format":"tact-ledger","version":1,"claims":[...]}, in the ledger's order; a claim is {"id",
///         "statement","source","method","bound","verdict","evidence","numbers":{name:integer},
///         "certificates":["certificates/NAME.json"],"seconds"}; a proved or refuted one without
///         certificates also has "no_certificate": why.
///         The same outcomes give the same bytes but for "seconds", which have lines of their own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

std::string LedgerJson(const std::vector<LedgerEntry>& entries);

/// Whether the text is a ledger as LedgerJson writes it (of any version).
bool IsLedgerJson(std::string_view text);

/// The certificate's file relative to the report: "certificates/NAME.json".
std::string CertificatePath(const Certificate& certificate);

}  // namespace tact::provers

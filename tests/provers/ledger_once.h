/// @file
/// The whole ledger at an effort, tried once a process: the tests that need it are one entry of CTest.
#pragma once

#include <map>
#include <vector>

#include "provers/claims/claims.h"

namespace tact::provers {

inline const std::vector<LedgerEntry>& LedgerOnce(Effort effort) {
  static std::map<Effort, std::vector<LedgerEntry>> ledgers;
  const auto [entry, is_new] = ledgers.try_emplace(effort);
  if (is_new) entry->second = TryClaims(AllClaims(), effort, {}, {}, 2);
  return entry->second;
}

}  // namespace tact::provers

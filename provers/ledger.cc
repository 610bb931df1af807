#include "provers/ledger.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <thread>

#include "algebra/error.h"

namespace tact::provers {
namespace {

void CheckClaims(const std::vector<Claim>& claims) {
  std::set<std::string> ids;
  for (const Claim& claim : claims) {
    if (claim.id.empty() || !claim.run) {
      throw PreconditionError("TryClaims: expected a claim with an id and a function to run, got id '" +
                              claim.id + "' and statement '" + claim.statement + "'");
    }
    if (!ids.insert(claim.id).second) {
      throw PreconditionError("TryClaims: expected distinct ids, got '" + claim.id + "' twice");
    }
  }
}

std::vector<LedgerEntry> Select(const std::vector<Claim>& claims, const std::vector<std::string>& globs) {
  std::vector<bool> chosen(claims.size(), globs.empty());
  for (const std::string& glob : globs) {
    bool matches = false;
    for (size_t i = 0; i < claims.size(); ++i) {
      if (!GlobMatches(glob, claims[i].id)) continue;
      chosen[i] = true;
      matches = true;
    }
    if (!matches) {
      std::string message = "--only: expected the id of a claim (* and ? are wildcards), got '" + glob +
                            "', which matches none of:";
      for (const Claim& claim : claims) message += "\n  " + claim.id;
      throw InputError(message);
    }
  }
  std::vector<LedgerEntry> entries;
  for (size_t i = 0; i < claims.size(); ++i) {
    if (chosen[i]) entries.push_back({claims[i], {}, 0});
  }
  return entries;
}

Outcome Undecided(std::string why) {
  Outcome outcome;
  outcome.bound = "none: the trial broke off";
  outcome.evidence = std::move(why);
  return outcome;
}

bool IsFileStem(const std::string& name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  };
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), allowed);
}

bool IsOneSvg(const std::string& svg) { return svg.starts_with("<svg") && svg.ends_with("</svg>"); }

// The first rule of Outcome that this one breaks.
std::optional<std::string> BrokenRule(const Outcome& outcome) {
  const bool decides = outcome.verdict == Verdict::kProved || outcome.verdict == Verdict::kRefuted;
  if (decides && outcome.certificates.empty() && outcome.no_certificate.empty()) {
    return "expected certificates or the reason why there are none, got neither";
  }
  std::set<std::string> numbers;
  for (const auto& [name, value] : outcome.numbers) {
    if (!numbers.insert(name).second) return "expected a name for each number, got '" + name + "' twice";
  }
  for (const Table& table : outcome.tables) {
    for (const auto& row : table.rows) {
      if (row.size() != table.header.size()) {
        return "expected rows of " + std::to_string(table.header.size()) + " cells in the table '" +
               table.caption + "', got one of " + std::to_string(row.size());
      }
    }
  }
  for (const Figure& figure : outcome.figures) {
    if (!IsOneSvg(figure.svg)) return "expected one <svg> element in the figure '" + figure.caption + "'";
  }
  std::set<std::string> certificates;
  for (const Certificate& certificate : outcome.certificates) {
    if (!IsFileStem(certificate.name)) {
      return "expected a certificate named with letters, digits, '.', '-' and '_', got '" + certificate.name +
             "'";
    }
    if (!certificates.insert(certificate.name).second) {
      return "expected a name for each certificate, got '" + certificate.name + "' twice";
    }
    if (!nlohmann::json::accept(certificate.json)) return "certificate '" + certificate.name + "' is no JSON";
  }
  return std::nullopt;
}

Outcome RunGuarded(const Claim& claim, Effort effort) {
  try {
    Outcome outcome = claim.run(effort);
    if (const auto broken = BrokenRule(outcome))
      throw InvariantError("its outcome breaks a rule: " + *broken);
    return outcome;
  } catch (const InvariantError& error) {
    return Undecided(std::string("The trial broke off on an error of tact itself: ") + error.what());
  } catch (const std::exception& error) {
    return Undecided(std::string("The trial broke off: ") + error.what());
  } catch (...) {
    return Undecided("The trial broke off: something was thrown that is no std::exception.");
  }
}

// Names of certificates are file names: of two claims that use one, the later loses, whichever was done
// first.
void UndecideRepeatedCertificates(std::vector<LedgerEntry>& entries) {
  std::map<std::string, std::string> owners;
  for (LedgerEntry& entry : entries) {
    for (const Certificate& certificate : entry.outcome.certificates) {
      const auto [owner, is_new] = owners.emplace(certificate.name, entry.claim.id);
      if (is_new || owner->second == entry.claim.id) continue;
      entry.outcome = Undecided("The trial's certificate '" + certificate.name + "' has the name of one of " +
                                owner->second + ".");
      break;
    }
  }
}

}  // namespace

std::string ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kProved:
      return "proved";
    case Verdict::kHoldsTo:
      return "holds to n";
    case Verdict::kRefuted:
      return "refuted";
    case Verdict::kReproduced:
      return "reproduced";
    case Verdict::kNotReproduced:
      return "not reproduced";
    case Verdict::kUndecided:
      return "undecided";
  }
  throw PreconditionError("ToString(Verdict): no such verdict: " + std::to_string(static_cast<int>(verdict)));
}

bool GlobMatches(std::string_view pattern, std::string_view text) {
  // On a mismatch, let the last star take one character more.
  size_t p = 0, t = 0, star = std::string_view::npos, taken = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<LedgerEntry> TryClaims(const std::vector<Claim>& claims, Effort effort,
                                   const std::vector<std::string>& only_globs, const Progress& progress,
                                   int threads) {
  CheckClaims(claims);
  std::vector<LedgerEntry> entries = Select(claims, only_globs);
  std::atomic<size_t> next = 0;
  size_t done = 0;
  std::mutex done_mutex;
  const auto work = [&] {
    for (size_t i = next++; i < entries.size(); i = next++) {
      LedgerEntry& entry = entries[i];
      const auto start = std::chrono::steady_clock::now();
      entry.outcome = RunGuarded(entry.claim, effort);
      entry.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const std::lock_guard lock(done_mutex);
      ++done;
      if (progress) progress(entry, done, entries.size());
    }
  };
  {
    std::vector<std::jthread> workers;
    const size_t wanted = std::min<size_t>(std::max(threads, 1), entries.size());
    for (size_t i = 1; i < wanted; ++i) workers.emplace_back(work);
    work();
  }
  UndecideRepeatedCertificates(entries);
  return entries;
}

}  // namespace tact::provers

/// @file
/// Claims on trial and what came out: the ledger that `tact verify` writes.
/// Model   A claim is stated before it is tried; trying it yields a verdict with numbers, prose, drawings and
///         certificates that `tact-check` re-checks on its own (docs/certificates.md).
/// Errors  InputError: an --only glob that matches no claim. PreconditionError: two claims with one id, a
///         claim without id or run. A claim that throws, or whose outcome breaks its rules, is undecided and
///         says why.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "provers/certificate.h"

namespace tact::provers {

enum class Verdict { kProved, kHoldsTo, kRefuted, kReproduced, kNotReproduced, kUndecided };
/// "proved", "holds to n", "refuted", "reproduced", "not reproduced", "undecided".
std::string ToString(Verdict verdict);

/// A drawing for the report: a caption and a complete <svg> element.
struct Figure {
  std::string caption;
  std::string svg;
};

/// A table for the report.
struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// What trying a claim gave. Rules: a proved or refuted claim has certificates or says why not; names of
/// numbers and of certificates are not repeated (the latter not even between claims) and a certificate's name
/// is made of letters, digits, `.`, `-` and `_`; rows are as long as their header; a certificate is JSON; a
/// figure is one <svg> element.
struct Outcome {
  Verdict verdict = Verdict::kUndecided;
  std::string bound;                                       // what it was tried to, for people
  std::string evidence;                                    // paragraphs separated by blank lines, for people
  std::vector<std::pair<std::string, long long>> numbers;  // counts, named
  std::vector<Certificate> certificates;
  std::string no_certificate;  // why a proved or refuted claim has none
  std::vector<Table> tables;
  std::vector<Figure> figures;
};

/// How long to try: kQuick for a look, kStandard for the ledger, kFull to the largest bound.
enum class Effort { kQuick, kStandard, kFull };

struct Claim {
  std::string id;         // "thesis.2.2.1.proposition-3"
  std::string statement;  // one sentence
  std::string source;     // its place in the thesis, "2.2.1, Proposition 3"
  std::string method;     // symbolic, exhaustive, property, statistics, simulation
  std::function<Outcome(Effort)> run;
};

struct LedgerEntry {
  Claim claim;
  Outcome outcome;
  double seconds = 0;
};

/// Told of each claim as it is done; called from one thread at a time, must not throw.
using Progress = std::function<void(const LedgerEntry& done, size_t done_count, size_t total)>;

/// Tries the claims whose id matches one of the globs (all of them if there is none) on that many threads,
/// and returns them in the order of `claims`.
std::vector<LedgerEntry> TryClaims(const std::vector<Claim>& claims, Effort effort,
                                   const std::vector<std::string>& only_globs = {},
                                   const Progress& progress = {}, int threads = 1);

/// Whether the whole text matches the pattern: `*` is any run of characters, `?` any one character.
bool GlobMatches(std::string_view pattern, std::string_view text);

}  // namespace tact::provers

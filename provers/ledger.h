/// @file
/// Claims on trial and what came out: the ledger that `tact verify` writes.
/// Model   A claim is stated before it is tried; trying it yields a verdict with numbers, prose, drawings and
///         certificates that `tact-check` re-checks on its own (docs/certificates.md).
#pragma once

#include <functional>
#include <string>
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

/// What trying a claim gave.
struct Outcome {
  Verdict verdict = Verdict::kUndecided;
  std::string bound;                                         // what it was tried to, for people
  std::string evidence;                                      // paragraphs separated by blank lines, for people
  std::vector<std::pair<std::string, long long>> numbers;    // counts, named
  std::vector<Certificate> certificates;
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

}  // namespace tact::provers

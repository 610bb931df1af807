#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <thread>

#include "cli/commands.h"
#include "provers/claims/claims.h"
#include "provers/report/report.h"

namespace tact::cli {
namespace {

using provers::LedgerEntry;

// One moving line on a terminal, a line a claim elsewhere; on stderr.
void ShowProgress(const LedgerEntry& done, size_t count, size_t total) {
  const bool terminal = isatty(STDERR_FILENO) == 1;
  std::fprintf(stderr, terminal ? "\r\033[K[%zu/%zu] %s: %s" : "[%zu/%zu] %s: %s\n", count, total,
               done.claim.id.c_str(), ToString(done.outcome.verdict).c_str());
  if (terminal && count == total) std::fprintf(stderr, "\r\033[K");
  std::fflush(stderr);
}

void PrintSummary(const std::vector<LedgerEntry>& entries, const std::string& directory) {
  size_t widest = 0;
  std::map<std::string, int> verdicts;
  for (const LedgerEntry& e : entries) {
    widest = std::max(widest, e.claim.id.size());
    ++verdicts[ToString(e.outcome.verdict)];
  }
  for (const LedgerEntry& e : entries) {
    std::printf("%-*s  %-14s %s\n", static_cast<int>(widest), e.claim.id.c_str(),
                ToString(e.outcome.verdict).c_str(), e.claim.source.c_str());
  }
  std::printf("\n");
  bool first = true;
  for (const auto& [verdict, count] : verdicts) {
    std::printf("%s%d %s", first ? "" : ", ", count, verdict.c_str());
    first = false;
  }
  std::printf("\nThe report is %s/index.html; tact-check %s checks its certificates.\n", directory.c_str(),
              directory.c_str());
}

}  // namespace

ExitStatus RunVerify(const VerifyOptions& options) {
  const provers::Effort effort = options.quick  ? provers::Effort::kQuick
                                 : options.full ? provers::Effort::kFull
                                                : provers::Effort::kStandard;
  provers::CheckReportPlace(options.directory);
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const auto entries = TryClaims(provers::AllClaims(), effort, options.only, ShowProgress, threads);
  provers::WriteReport(entries, options.directory);
  PrintSummary(entries, options.directory);
  const bool undecided = std::any_of(entries.begin(), entries.end(), [](const LedgerEntry& e) {
    return e.outcome.verdict == provers::Verdict::kUndecided;
  });
  return undecided ? kUndecided : kAnswered;
}

}  // namespace tact::cli

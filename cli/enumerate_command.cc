#include <algorithm>
#include <chrono>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/dof_class_text.h"
#include "cli/output.h"
#include "cli/unit_run.h"
#include "cli/world_option.h"
#include "enumerators/dof_counts_text.h"
#include "provers/report/dof_class_page.h"

namespace tact::cli {
namespace {

using enumerators::DofCensus;

DofCensus MakeCensus(const EnumerateOptions& options) {
  enumerators::ContactWorld world = ReadWorld(options, 0);
  try {
    return DofCensus(std::move(world));
  } catch (const PreconditionError& error) {
    throw InputError("--contacts: expected a world that can be counted, got " + std::string(error.what()));
  }
}

// Seconds a relation of the largest kind.
double MeasureSeconds(const DofCensus& census) {
  constexpr uint64_t kSample = 5000;
  const uint64_t first = census.relations() - std::min(census.relations(), kSample);
  const auto start = std::chrono::steady_clock::now();
  census.CountRange(first, census.relations());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>(census.relations() - first);
}

}  // namespace

ExitStatus RunEnumerateDofClasses(const EnumerateOptions& options) {
  const UnitRunner runner(options);
  const DofCensus census = MakeCensus(options);
  const enumerators::UnitRun run = {DescribeCensus(census, options.world, TACT_VERSION), census.units(),
                                    [&](size_t unit) { return enumerators::ToText(census.CountUnit(unit)); }};
  const RunCost cost = {static_cast<double>(census.relations()), "relations",
                        [&] { return MeasureSeconds(census); }};
  enumerators::DofCounts counts;
  const bool all = runner.Run(run, cost, [&](const std::string& text) {
    DofCensus::Merge(counts, enumerators::ParseDofCounts(text));
  });
  if (!all) return kAnswered;

  const DofClassAnswer answer = {options.world, census, enumerators::ListDofClasses(counts)};
  const std::string json = ToJson(answer), csv = ToCsv(answer);
  if (runner.keeps()) {
    runner.Keep("classes.json", json);
    runner.Keep("classes.csv", csv);
    runner.Keep("index.html", provers::DofClassPage(census, answer.lists));
  }
  Output out;
  out << (options.json ? json : options.csv ? csv : ToTable(answer));
  if (runner.keeps() && !options.json && !options.csv)
    out << "The report is " + options.directory + "/index.html.\n";
  out.Flush();
  return kAnswered;
}

}  // namespace tact::cli

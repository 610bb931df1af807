#include <algorithm>
#include <chrono>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/dof_transition_text.h"
#include "cli/output.h"
#include "cli/unit_run.h"
#include "cli/world_option.h"

namespace tact::cli {
namespace {

using enumerators::DofStepCensus;

DofStepCensus MakeCensus(const EnumerateOptions& options) {
  enumerators::ContactWorld world = ReadWorld(options, 1);
  try {
    return DofStepCensus(std::move(world));
  } catch (const PreconditionError& error) {
    throw InputError("--contacts: expected a world that can be counted, got " + std::string(error.what()));
  }
}

// Seconds a step from relations of the largest kind.
double MeasureSeconds(const DofStepCensus& census) {
  constexpr double kSample = 10000;
  const auto relations = static_cast<uint64_t>(kSample / static_cast<double>(census.additions().size())) + 1;
  const uint64_t first = census.relations() - std::min(census.relations(), relations);
  const auto start = std::chrono::steady_clock::now();
  census.CountRange(first, census.relations());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>((census.relations() - first) * census.additions().size());
}

}  // namespace

ExitStatus RunEnumerateDofTransitions(const EnumerateOptions& options) {
  const UnitRunner runner(options);
  const DofStepCensus census = MakeCensus(options);
  const enumerators::UnitRun run = {DescribeCensus(census, options.world, TACT_VERSION), census.units(),
                                    [&](size_t unit) { return enumerators::ToText(census.CountUnit(unit)); }};
  const RunCost cost = {census.steps_at_most(), "steps", [&] { return MeasureSeconds(census); }};
  enumerators::DofSteps steps;
  const bool all = runner.Run(run, cost, [&](const std::string& text) {
    DofStepCensus::Merge(steps, enumerators::ParseDofSteps(text));
  });
  if (!all) return kAnswered;

  constexpr size_t kNormals = 4;  // more add no step between the kinds in translation
  provers::DofTransitionFindings findings{census,
                                          enumerators::ListDofSteps(steps),
                                          enumerators::CountDirectBlocks(steps),
                                          enumerators::TranslationSteps(kNormals),
                                          provers::ShowScenes(),
                                          {}};
  findings.shown = provers::ShownTransitions(findings.scenes);
  Output out;
  if (runner.keeps()) {
    runner.Keep("transitions.json", ToJson(findings, options.world));
    runner.Keep("transitions.csv", ToCsv(findings));
    runner.Keep("index.html", provers::DofTransitionPage(findings));
  }
  out << (options.json ? ToJson(findings, options.world) : options.csv ? ToCsv(findings) : ToTable(findings));
  if (runner.keeps() && !options.json && !options.csv)
    out << "The report is " + options.directory + "/index.html.\n";
  out.Flush();
  return kAnswered;
}

}  // namespace tact::cli

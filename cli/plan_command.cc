#include <algorithm>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/plan_answer.h"

namespace tact::cli {
namespace {

constexpr long long kMostSamples = 100000;  // a segment: what memory holds

}  // namespace

ExitStatus RunPlan(const PlanOptions& options) {
  if (options.samples < 1 || options.samples > kMostSamples)
    throw InputError("--samples: expected 1 to " + std::to_string(kMostSamples) + " samples a segment, got " +
                     std::to_string(options.samples));
  input::InputFile file(options.file);
  PlanAnswer answer{planning::StatesOf(input::ReadDemonstration(file.stream(), file.name()), file.name()),
                    {}};
  auto& demonstration = answer.demonstration;
  if (options.reverse) std::reverse(demonstration.states.begin(), demonstration.states.end());
  for (size_t i = 0; i + 1 < demonstration.states.size(); ++i) {
    PlanAnswer::Step step{PlanTransition(demonstration, i, i + 1, static_cast<int>(options.samples)), {}};
    if (!options.closed_form) {
      for (const auto definition : {planning::PathDefinition::kLeast, planning::PathDefinition::kThesis})
        step.ipopt.push_back(PlanByIpopt(demonstration.solids, demonstration.states[i].state,
                                         demonstration.states[i + 1].state, step.planned.trajectory,
                                         definition));
    }
    answer.steps.push_back(std::move(step));
  }
  for (const std::string& note : demonstration.notes) Note(note);
  if (!options.page.empty()) WritePlanPage(answer, options.page);
  Output output;
  output << (options.json ? PlanJson(answer) : PlanText(answer));
  output.Flush();
  const bool failed = std::any_of(answer.steps.begin(), answer.steps.end(), [](const PlanAnswer::Step& step) {
    return !step.planned.failure().empty();
  });
  return failed ? kUndecided : kAnswered;
}

}  // namespace tact::cli

/// @file
/// What `tact plan` answers with: transitions planned in closed form and by Ipopt; as text, JSON and a page.
/// Errors  InputError: the page cannot be written.
#pragma once

#include <string>
#include <vector>

#include "robot/planning/demonstration_plan.h"
#include "robot/planning/ipopt_plan.h"

namespace tact::cli {

struct PlanAnswer {
  planning::DemonstrationStates demonstration;
  struct Step {
    planning::PlannedTransition planned;
    std::vector<planning::IpoptPlan> ipopt;  // least, thesis; or none
  };
  std::vector<Step> steps;
};

std::string PlanText(const PlanAnswer& answer);
/// One object, one line (docs/plans.md).
std::string PlanJson(const PlanAnswer& answer);
void WritePlanPage(const PlanAnswer& answer, const std::string& path);

/// Cells of the tables, for people: "A -> B", the case, the turns' axes, ...
std::vector<std::string> PlanHeader(const PlanAnswer& answer);
std::vector<std::string> PlanCells(const PlanAnswer& answer, const PlanAnswer::Step& step);
std::vector<std::string> IpoptHeader(const PlanAnswer& answer);
std::vector<std::string> IpoptCells(const PlanAnswer& answer, const PlanAnswer::Step& step,
                                    size_t definition);

}  // namespace tact::cli

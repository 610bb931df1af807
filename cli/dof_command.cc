#include "algebra/contact/motion_dof.h"
#include "cli/commands.h"
#include "cli/dof_table.h"
#include "cli/each_relation.h"
#include "cli/json_text.h"

namespace tact::cli {

ExitStatus RunDof(const FileOptions& options) {
  AnswerEachRelation(options, [&](const algebra::ContactRelation& relation) {
    const algebra::MotionDof dof = ComputeMotionDof(relation);
    return options.json ? ToJson(dof) + "\n" : DofTable(dof);
  });
  return kAnswered;
}

}  // namespace tact::cli

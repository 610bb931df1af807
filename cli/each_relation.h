/// @file
/// What the commands about contact relations share: walk a file, answer relation after relation, in order.
/// Cost    the memory of one relation and one answer.
#pragma once

#include <functional>
#include <string>

#include "algebra/contact/contact_relation.h"
#include "cli/commands.h"

namespace tact::cli {

/// Writes answer(relation) for each relation of the file; for people, several answers are numbered.
/// InputError: the file; and what the answer refuses (PreconditionError), with the relation's place. BudgetError: likewise.
void AnswerEachRelation(const FileOptions& options,
                        const std::function<std::string(const algebra::ContactRelation&)>& answer);

}  // namespace tact::cli

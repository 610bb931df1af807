#include "cli/each_relation.h"

#include "algebra/error.h"
#include "cli/cad_contacts.h"
#include "cli/output.h"
#include "robot/input/relation_file.h"

namespace tact::cli {
namespace {

algebra::ContactRelation ContactsOf(input::RelationInput input) {
  if (const auto* cad = std::get_if<input::CadRelation>(&input)) return ContactsFromCad(*cad);
  return std::get<algebra::ContactRelation>(std::move(input));
}

}  // namespace

void AnswerEachRelation(const FileOptions& options,
                        const std::function<std::string(const algebra::ContactRelation&)>& answer) {
  input::InputFile file(options.file);
  input::RelationStream relations(file.stream(), file.name());
  Output output;
  size_t number = 0;
  bool several = false;
  while (auto input = relations.Next()) {
    ++number;
    const algebra::ContactRelation relation = ContactsOf(std::move(*input));
    std::string text;
    try {
      text = answer(relation);
    } catch (const PreconditionError& error) {
      throw InputError(relations.where() + ": " + error.what());
    } catch (const BudgetError& error) {
      throw BudgetError(relations.where() + ": " + error.what());
    }
    if (!options.json) {
      several = several || relations.HasMore();
      if (several) output << (number > 1 ? "\n" : "") << "relation " << std::to_string(number) << "\n";
    }
    output << text;
  }
  output.Flush();
}

}  // namespace tact::cli

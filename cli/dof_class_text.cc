#include "cli/dof_class_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/json_text.h"
#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

using enumerators::DofClassList;
using enumerators::FoundClass;

std::string Numbers(const std::vector<int>& values) {
  return Join(values, ",", [](int value) { return std::to_string(value); });
}

std::string Witness(const DofClassAnswer& answer, const FoundClass& found) {
  return R"({"contacts":)" + ContactsToJson(answer.census.Relation(found.witness)) + "}";
}

std::string ListToJson(const DofClassAnswer& answer, const DofClassList& list) {
  const std::string classes = Join(list.found, ",\n", [&](const FoundClass& found) {
    return fmt::format(R"({{"values":[{}],"count":{},"witness":{}}})", Numbers(found.values), found.count,
                       Witness(answer, found));
  });
  return fmt::format(
      "{{\"name\":{},\"indices\":[{}],\"classes\":{},\"complete\":{},\"upper_bound\":{},\"list\":[\n{}]}}",
      JsonString(list.definition->name), Join(list.definition->indices, ",", JsonString), list.found.size(),
      list.complete(), list.upper_bound, classes);
}

}  // namespace

std::string ToTable(const DofClassAnswer& answer) {
  std::string table =
      fmt::format("{:>7}  {:>8}  {}\n", "classes", "at most", "indices that tell two relations apart");
  for (const DofClassList& list : answer.lists) {
    table += fmt::format("{:>7}  {:>8}  {}\n", list.found.size(), list.upper_bound, list.definition->name);
  }
  const bool complete = std::ranges::all_of(answer.lists, &DofClassList::complete);
  table += complete ? "Complete: every class that the lemmas allow has a witness.\n"
                    : "Not complete: some classes that the lemmas allow have no witness in this world.\n";
  if (enumerators::IsBoxWorld(answer.census.world())) {
    table += fmt::format(
        "Of solids whose faces are all parallel to coordinate planes there are {} of the finest classes; {} "
        "have "
        "a witness here.\n",
        enumerators::BoxClasses().size(), answer.lists.back().found.size());
  }
  return table + fmt::format("Witnesses from {} relations without repetition: {}.\n",
                             answer.census.relations(), answer.census.world().sentence);
}

std::string ToJson(const DofClassAnswer& answer) {
  const enumerators::ContactWorld& world = answer.census.world();
  return fmt::format(
      "{{\"definitions\":[\n{}],\n\"world\":{{\"name\":{},\"sentence\":{},\"contacts\":{},\"largest\":{}}},"
      "\"relations\":{}}}\n",
      Join(answer.lists, ",\n", [&](const DofClassList& list) { return ListToJson(answer, list); }),
      JsonString(answer.world), JsonString(world.sentence), world.contacts.size(), world.largest,
      answer.census.relations());
}

std::string ToCsv(const DofClassAnswer& answer) {
  const DofClassList& finest = answer.lists.back();
  std::string csv = Join(finest.definition->indices, ",", [](const std::string& name) { return name; }) +
                    ",relations,contacts,witness\n";
  for (const FoundClass& found : finest.found) {
    csv += fmt::format("{},{},{},{}\n", Numbers(found.values), found.count, found.witness.size(),
                       CsvString(Witness(answer, found)));
  }
  return csv;
}

}  // namespace tact::cli

#include "cli/dof_transition_text.h"

#include <fmt/format.h>

#include "cli/json_text.h"
#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

using algebra::DofTransition;
using enumerators::DofStepCensus;
using enumerators::DofStepList;
using enumerators::FoundStep;
using enumerators::StepDefinition;
using enumerators::StepWitness;
using provers::DofTransitionFindings;
using provers::ShownScene;
using provers::ShownTransition;

template <typename Numbers>
std::string List(const Numbers& numbers) {
  return "[" + Join(numbers, ",", [](int n) { return std::to_string(n); }) + "]";
}

std::string ContactsObject(const algebra::ContactRelation& relation) {
  return R"({"contacts":)" + ContactsToJson(relation) + "}";
}

std::string StepsToJson(const StepDefinition& definition) {
  return fmt::format(R"({{"definition":{},"pairs":{},"list":[{}]}})", JsonString(definition.name),
                     definition.steps.size(), Join(definition.steps, ",", [](const auto& step) {
                       return R"({"from":)" + List(step.first) + R"(,"to":)" + List(step.second) + "}";
                     }));
}

std::string WitnessToJson(const DofStepCensus& census, const StepWitness& witness) {
  return R"({"relation":)" + ContactsObject(census.Relation(witness.relation)) + R"(,"added":)" +
         ContactsObject(census.Relation(witness.added)) + "}";
}

std::string ListToJson(const DofStepCensus& census, const DofStepList& list) {
  return fmt::format("{{\"name\":{},\"indices\":[{}],\"pairs\":{},\"within\":{},\"list\":[\n{}]}}",
                     JsonString(list.definition->name), Join(list.definition->indices, ",", JsonString),
                     list.found.size(), list.within, Join(list.found, ",\n", [&](const FoundStep& found) {
                       return fmt::format(R"({{"from":{},"to":{},"count":{},"witness":{}}})",
                                          List(found.from), List(found.to), found.count,
                                          WitnessToJson(census, found.witness));
                     }));
}

// The lists of one addition are in a row.
std::string AdditionToJson(const DofTransitionFindings& findings, enumerators::AdditionKind kind) {
  size_t additions = 0;
  for (const enumerators::Addition& addition : findings.census.additions())
    additions += addition.kind == kind ? 1 : 0;
  uint64_t steps = 0;
  std::vector<std::string> definitions;
  for (const DofStepList& list : findings.lists) {
    if (list.kind != kind) continue;
    steps = list.steps();
    definitions.push_back(ListToJson(findings.census, list));
  }
  return fmt::format("{{\"added\":\"{}\",\"additions\":{},\"steps\":{},\"definitions\":[\n{}]}}",
                     enumerators::ToString(kind), additions, steps, fmt::join(definitions, ",\n"));
}

std::string BlocksToJson(const DofStepCensus& census, const enumerators::DirectBlocks& blocks) {
  return fmt::format(R"({{"added":"{}","motion":"{}","steps":{}{}}})", enumerators::ToString(blocks.kind),
                     ToString(blocks.motion), blocks.steps,
                     blocks.smallest ? R"(,"witness":)" + WitnessToJson(census, *blocks.smallest) : "");
}

std::string PiecesToJson(const std::vector<std::vector<algebra::Vector3>>& pieces) {
  return "[" +
         Join(pieces, ",",
              [](const auto& piece) {
                return "[" + Join(piece, ",", [](const algebra::Vector3& corner) { return ToJson(corner); }) +
                       "]";
              }) +
         "]";
}

std::string PathToJson(const algebra::MotionPath& path) {
  return path.kind == algebra::MotionPath::Kind::kLine
             ? R"({"kind":"line","direction":)" + ToJson(path.vector) + "}"
             : R"({"kind":"rotation","center":)" + ToJson(path.center) + R"(,"axis":)" + ToJson(path.vector) +
                   "}";
}

std::string SceneToJson(const ShownScene& scene, bool backwards) {
  const auto state = [](const algebra::ContactRelation& relation, const algebra::MotionDof& dof) {
    return R"({"contacts":)" + ContactsToJson(relation) + R"(,"dof":)" + ToJson(dof) + "}";
  };
  const std::string start = state(scene.before, scene.dof_before), end = state(scene.after, scene.dof_after);
  const algebra::Scene& solids = scene.given.scene;
  return fmt::format(
      R"({{"story":{},"backwards":{},"before":{},"after":{},"path":{},"moving":{},"fixed":{}}})",
      JsonString(scene.given.story), backwards, backwards ? end : start, backwards ? start : end,
      PathToJson(solids.path), PiecesToJson(solids.moving_pieces), PiecesToJson(solids.fixed_pieces));
}

std::string ShownToJson(const DofTransitionFindings& findings, const ShownTransition& shown) {
  const DofTransition& t = shown.transition;
  std::string text =
      fmt::format(R"({{"motion":"{}","from":"{}","to":"{}","practical":{},"occurs":{},"forced_by_counts":{})",
                  ToString(t.motion), ToString(t.from), ToString(t.to), IsPractical(t),
                  shown.scene.has_value(), shown.forced);
  if (shown.scene) text += R"(,"witness":)" + SceneToJson(findings.scenes.at(*shown.scene), shown.backwards);
  return text + "}";
}

}  // namespace

std::string ToJson(const DofTransitionFindings& findings, const std::string& world_name) {
  const enumerators::ContactWorld& world = findings.census.world();
  std::vector<std::string> additions;
  for (size_t kind = 0; kind < enumerators::kAdditionKinds; ++kind)
    additions.push_back(AdditionToJson(findings, static_cast<enumerators::AdditionKind>(kind)));
  return fmt::format(
      "{{\"translation_steps\":[\n{}],\n\"class_steps\":[\n{}],\n\"maintaining_to_constraining\":[\n{}],"
      "\n\"dof_transitions\":[\n{}],\n"
      "\"world\":{{\"name\":{},\"sentence\":{},\"contacts\":{},\"largest\":{}}},\"relations\":{}}}\n",
      Join(findings.translation, ",\n", StepsToJson), fmt::join(additions, ",\n"),
      Join(findings.direct_blocks, ",\n",
           [&](const enumerators::DirectBlocks& blocks) { return BlocksToJson(findings.census, blocks); }),
      Join(findings.shown, ",\n", [&](const ShownTransition& shown) { return ShownToJson(findings, shown); }),
      JsonString(world_name), JsonString(world.sentence), world.contacts.size(), world.largest,
      findings.census.relations());
}

std::string ToCsv(const DofTransitionFindings& findings) {
  const enumerators::DofDefinition& finest = enumerators::DofDefinitions().back();
  const auto heads = [&](const std::string& prefix) {
    return Join(finest.indices, "", [&](const std::string& index) { return "," + prefix + index; });
  };
  std::string csv = "added" + heads("before.") + heads("after.") + ",steps,relation,contacts\n";
  const auto values = [](int value) { return std::to_string(value); };
  for (const DofStepList& list : findings.lists) {
    if (list.definition != &finest) continue;
    for (const FoundStep& found : list.found) {
      csv += fmt::format("{},{},{},{},{},{}\n", enumerators::ToString(list.kind),
                         Join(found.from, ",", values), Join(found.to, ",", values), found.count,
                         CsvString(ContactsObject(findings.census.Relation(found.witness.relation))),
                         CsvString(ContactsObject(findings.census.Relation(found.witness.added))));
    }
  }
  return csv;
}

}  // namespace tact::cli

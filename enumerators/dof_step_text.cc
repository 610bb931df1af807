#include <tuple>

#include "enumerators/dof_class.h"
#include "enumerators/dof_step_census.h"
#include "enumerators/unit_text.h"

namespace tact::enumerators {
namespace {

AdditionKind ReadKind(TextReader& reader) {
  for (size_t i = 0; i < kAdditionKinds; ++i) {
    const auto kind = static_cast<AdditionKind>(i);
    if (reader.Take("\"" + ToString(kind) + "\"")) return kind;
  }
  reader.Refuse("what is added");
}

}  // namespace

std::string ToText(const DofSteps& steps) {
  std::string text = "[";
  for (const DofStep& step : steps) {
    text += text.size() > 1 ? ",\n" : "\n";
    text += "{\"added\":\"" + ToString(step.kind) + "\",\"before\":" + std::to_string(step.before) +
            ",\"after\":" + std::to_string(step.after) + ",\"count\":" + std::to_string(step.count) +
            ",\"relation\":" + ListText(step.witness.relation) +
            ",\"contacts\":" + ListText(step.witness.added) + "}";
  }
  return text + "]";
}

DofSteps ParseDofSteps(std::string_view text) {
  const size_t classes = DofClasses().size();
  const auto key = [](const DofStep& s) { return std::tuple(s.kind, s.before, s.after); };
  TextReader reader(text);
  DofSteps steps;
  reader.Expect("[");
  while (!reader.Take("]")) {
    reader.Expect(steps.empty() ? "\n{\"added\":" : ",\n{\"added\":");
    DofStep step;
    step.kind = ReadKind(reader);
    reader.Expect(",\"before\":");
    step.before = reader.Number<size_t>();
    reader.Expect(",\"after\":");
    step.after = reader.Number<size_t>();
    if (step.before >= classes || step.after >= classes) reader.Refuse("numbers of DOF classes");
    reader.Expect(",\"count\":");
    step.count = reader.Number<uint64_t>();
    reader.Expect(",\"relation\":");
    step.witness.relation = reader.Numbers<size_t>();
    reader.Expect(",\"contacts\":");
    step.witness.added = reader.Numbers<size_t>();
    reader.Expect("}");
    if (!steps.empty() && key(steps.back()) >= key(step))
      reader.Refuse("steps by addition, class before, class after");
    steps.push_back(std::move(step));
  }
  reader.ExpectEnd();
  return steps;
}

std::string DescribeCensus(const DofStepCensus& census, const std::string& world,
                           const std::string& version) {
  return DescribeRun("dof-transitions", version, world, census.world(), census.relations(),
                     census.relations_in_a_unit());
}

}  // namespace tact::enumerators

#include "robot/input/demonstration.h"

#include <utility>

#include "robot/input/relation_file.h"

namespace tact::input {
namespace {

std::string NameOf(const JsonValue& object, size_t index) {
  if (const auto name = object.Find("name")) return name->ReadString("a name in quotes");
  return std::to_string(index + 1);
}

PoseDemonstration ParseStates(const JsonValue& value, const std::string& source) {
  value.ExpectObject({"moving", "fixed", "unit", "tolerance", "states"});
  PoseDemonstration demonstration;
  demonstration.models = ParseCadModels(value, source);
  const JsonValue states = value.At("states");
  for (const JsonValue state : states.Elements("an array of states")) {
    state.ExpectObject({"name", "time", "pose"});
    const std::string name = NameOf(state, demonstration.states.size());
    demonstration.states.push_back({name, ParsePose(state.At("pose")), state.Where(), std::nullopt});
    if (const auto time = state.Find("time")) demonstration.states.back().time = time->ReadRational();
  }
  if (demonstration.states.empty()) states.FailExpected("at least one state");
  return demonstration;
}

RelationDemonstration ParseRelations(const JsonValue& value) {
  value.ExpectObject({"relations"});
  RelationDemonstration demonstration;
  const JsonValue relations = value.At("relations");
  for (const JsonValue relation : relations.Elements("an array of contact relations")) {
    algebra::ContactRelation parsed = ParseRelation(relation);
    demonstration.relations.push_back({NameOf(relation, demonstration.relations.size()), std::move(parsed)});
  }
  if (demonstration.relations.empty()) relations.FailExpected("at least one contact relation");
  return demonstration;
}

}  // namespace

Demonstration ReadDemonstration(std::istream& in, const std::string& source) {
  JsonStream documents(in, source);
  auto document = documents.Next();
  const JsonValue first = document->root();
  const bool has_states =
      first.is_object() && (first.Find("states") || first.Find("moving") || first.Find("fixed"));
  const bool has_relations = first.is_object() && first.Find("relations");
  if (has_states || has_relations) {
    Demonstration demonstration =
        has_states ? Demonstration(ParseStates(first, source)) : Demonstration(ParseRelations(first));
    if (const auto more = documents.Next()) {
      more->root().Fail("expected the end of the file after the demonstration, got " +
                        more->root().Describe());
    }
    return demonstration;
  }
  if (first.is_object() && !first.Find("contacts")) {
    first.Fail(
        "expected a demonstration with \"states\", with \"relations\" or with \"contacts\", got none of "
        "them");
  }
  RelationDemonstration demonstration;
  for (; document; document = documents.Next()) {
    algebra::ContactRelation parsed = ParseRelation(document->root());
    demonstration.relations.push_back(
        {NameOf(document->root(), demonstration.relations.size()), std::move(parsed)});
  }
  return demonstration;
}

}  // namespace tact::input

#include "robot/input/cad_relation.h"

#include <limits>

#include "robot/input/length_unit.h"

namespace tact::input {
namespace {

using algebra::Element;
using algebra::ElementKind;

std::filesystem::path ParsePath(const JsonValue& value, const std::string& source) {
  constexpr std::string_view kWanted = "the name of a CAD file";
  const std::string name = value.ReadString(kWanted);
  if (name.empty()) value.FailExpected(kWanted);
  const std::filesystem::path path(name);
  return path.is_absolute() ? path : std::filesystem::path(source).parent_path() / path;
}

Element ParseElement(const JsonValue& value) {
  value.ExpectObject({"vertex", "edge", "face"});
  if (value.size() != 1)
    value.Fail("expected one of \"vertex\", \"edge\" and \"face\", got " + std::to_string(value.size()) +
               " of them");
  constexpr int64_t kLast = std::numeric_limits<int32_t>::max();
  if (const auto vertex = value.Find("vertex")) {
    return {ElementKind::kVertex, static_cast<size_t>(vertex->ReadInteger(0, kLast))};
  }
  if (const auto edge = value.Find("edge")) {
    return {ElementKind::kEdge, static_cast<size_t>(edge->ReadInteger(0, kLast))};
  }
  return {ElementKind::kFace, static_cast<size_t>(value.At("face").ReadInteger(0, kLast))};
}

}  // namespace

CadModels ParseCadModels(const JsonValue& object, const std::string& source) {
  CadModels models;
  models.moving = ParsePath(object.At("moving"), source);
  models.fixed = ParsePath(object.At("fixed"), source);
  const auto unit = object.Find("unit");
  if (!unit) {
    object.Fail(
        "expected a unit, got none; a mesh has no unit: give \"unit\":\"mm\", \"cm\", \"m\" or \"in\"");
  }
  models.unit = ParseLengthUnit(*unit);
  if (const auto tolerance = object.Find("tolerance")) {
    models.tolerance = tolerance->ReadRational();
    if (models.tolerance.sign() < 0) tolerance->FailExpected("a tolerance that is not negative");
  }
  return models;
}

CadRelation ParseCadRelation(const JsonValue& value, const std::string& source) {
  value.ExpectObject({"name", "moving", "fixed", "unit", "pose", "tolerance", "contacts"});
  CadRelation relation;
  relation.models = ParseCadModels(value, source);
  relation.pose = ParsePose(value.At("pose"));
  relation.where = value.Where();
  if (const auto contacts = value.Find("contacts")) {
    relation.contacts.emplace();
    for (const JsonValue pair : contacts->Elements("an array of element pairs")) {
      pair.ExpectObject({"moving", "fixed"});
      relation.contacts->push_back(
          {ParseElement(pair.At("moving")), ParseElement(pair.At("fixed")), pair.Where()});
    }
  }
  return relation;
}

}  // namespace tact::input

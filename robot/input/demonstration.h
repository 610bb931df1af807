/// @file
/// Demonstrations: what was seen, state after state.
/// Model
/// {"moving":"peg.off","fixed":"slot.off","unit":"mm","tolerance":0,"states":[{"name":"A","pose":{...}},...]},
///         or {"relations":[{"name":"A","contacts":[...]},...]}, or contact relations one a line.
///         A state without a name has its number, from 1, as its name; it may have a "time" in seconds.
/// Errors  InputError; among it a demonstration without states.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "algebra/contact/contact_relation.h"
#include "robot/input/cad_relation.h"
#include "robot/input/json_stream.h"

namespace tact::input {

struct NamedPose {
  std::string name;
  PoseInput pose;
  std::string where;  // "file:line:column"
  std::optional<algebra::Rational> time = std::nullopt;
};

/// Two solids and the poses of the moving one.
struct PoseDemonstration {
  CadModels models;
  std::vector<NamedPose> states;
};

struct NamedRelation {
  std::string name;
  algebra::ContactRelation relation;
  friend bool operator==(const NamedRelation&, const NamedRelation&) = default;
};

/// Contact relations given as such.
struct RelationDemonstration {
  std::vector<NamedRelation> relations;
};

using Demonstration = std::variant<PoseDemonstration, RelationDemonstration>;

Demonstration ReadDemonstration(std::istream& in, const std::string& source);

}  // namespace tact::input

/// @file
/// The CAD form of a contact relation: two solids' files, a pose, and perhaps which elements touch.
/// Model   {"moving":"peg.off","fixed":"hole.off","unit":"mm","pose":{...},"tolerance":0,
///          "contacts":[{"moving":{"vertex":3},"fixed":{"face":5}},...]}. Without "contacts" they are to be
///          found.
/// Frames  the pose is that of the moving solid's frame in the fixed one's.
/// Units   coordinates, translation and tolerance all have the unit that is named; it must be, a mesh has
/// none. Errors  InputError.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algebra/contact/local_cone.h"
#include "robot/cad/length_unit.h"
#include "robot/input/pose.h"

namespace tact::input {

/// An element's index counts from 0 in the order of algebra::Polyhedron.
struct ElementPair {
  algebra::Element moving, fixed;
  std::string where = {};  // "file:line:column"; two pairs may be equal in different places
  friend bool operator==(const ElementPair& a, const ElementPair& b) {
    return a.moving == b.moving && a.fixed == b.fixed;
  }
};

/// Two solids' files, relative names taken from the folder of the file that names them.
struct CadModels {
  std::filesystem::path moving, fixed;
  cad::LengthUnit unit = cad::LengthUnit::kMillimetre;
  algebra::Rational tolerance;  // not negative, in that unit
};

struct CadRelation {
  CadModels models;
  PoseInput pose;
  std::optional<std::vector<ElementPair>> contacts;
  std::string where;  // "file:line:column", for whoever finds something wrong with it later
};

/// Reads "moving", "fixed", "unit" and "tolerance" of an object; source is the name of the file.
CadModels ParseCadModels(const JsonValue& object, const std::string& source);
CadRelation ParseCadRelation(const JsonValue& value, const std::string& source);

}  // namespace tact::input

/// @file
/// Contact relation files.
/// Model   {"contacts":[{"point":[x,y,z],"planes":[[nx,ny,nz],...],"name":"..."}]}, a plane's normal to the
/// legal side;
///         or the CAD form. Many relations stand one a line. "name" may be left out, and names a relation
///         too.
/// Units   points in one length unit of the file's own choice.
/// Errors  InputError: what is not of this form, a zero normal, a contact without planes.
/// Cost    a stream of relations takes the memory of one.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <variant>

#include "algebra/contact/contact_relation.h"
#include "robot/input/cad_relation.h"
#include "robot/input/json_stream.h"

namespace tact::input {

algebra::ContactRelation ParseRelation(const JsonValue& value);

using RelationInput = std::variant<algebra::ContactRelation, CadRelation>;

/// Either form: it is the CAD form if it has "moving" or "fixed"; source is the name of the file.
RelationInput ParseRelationInput(const JsonValue& value, const std::string& source);

/// The relations of a file, one by one.
class RelationStream {
 public:
  RelationStream(std::istream& in, std::string source) : documents_(in, std::move(source)) {}

  /// The next relation; nullopt at the end.
  std::optional<RelationInput> Next();
  bool HasMore() { return documents_.HasMore(); }
  /// "file:line:column" of the relation that Next gave last.
  const std::string& where() const { return where_; }

 private:
  JsonStream documents_;
  std::string where_;
};

}  // namespace tact::input

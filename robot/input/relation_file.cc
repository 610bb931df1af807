#include "robot/input/relation_file.h"

namespace tact::input {
namespace {

algebra::Contact ParseContact(const JsonValue& value) {
  value.ExpectObject({"point", "planes", "name"});
  algebra::Contact contact;
  contact.point = value.At("point").ReadVector3();
  const JsonValue planes = value.At("planes");
  const auto normals = planes.Elements("an array of normals [[nx, ny, nz], ...]");
  if (normals.size() == 0) {
    planes.Fail("expected at least one plane, got none; a contact that restricts nothing is to be left out");
  }
  contact.planes.reserve(normals.size());
  for (const JsonValue normal : normals) {
    contact.planes.push_back(normal.ReadVector3());
    if (contact.planes.back().IsZero()) normal.Fail("expected a normal that is not zero, got [0, 0, 0]");
  }
  if (const auto name = value.Find("name")) contact.name = name->ReadString("a name in quotes");
  return contact;
}

}  // namespace

algebra::ContactRelation ParseRelation(const JsonValue& value) {
  value.ExpectObject({"contacts", "name"});
  if (const auto name = value.Find("name")) name->ReadString("a name in quotes");
  algebra::ContactRelation relation;
  const auto contacts = value.At("contacts").Elements("an array of contacts");
  relation.contacts.reserve(contacts.size());
  for (const JsonValue contact : contacts) relation.contacts.push_back(ParseContact(contact));
  return relation;
}

RelationInput ParseRelationInput(const JsonValue& value, const std::string& source) {
  if (value.is_object() && (value.Find("moving") || value.Find("fixed")))
    return ParseCadRelation(value, source);
  return ParseRelation(value);
}

std::optional<RelationInput> RelationStream::Next() {
  const auto document = documents_.Next();
  if (!document) return std::nullopt;
  where_ = document->root().Where();
  return ParseRelationInput(document->root(), document->source());
}

}  // namespace tact::input

// Any bytes are a relation file, a demonstration and a pose, or are refused as bad input with a place; a relation that is
// read has planes, and none is zero.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "robot/input/demonstration.h"
#include "robot/input/relation_file.h"

namespace {

using namespace tact;  // NOLINT: a program of one file

void Require(bool holds) {
  if (!holds) std::abort();
}

template <typename Read>
void AcceptOrRefuse(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    Require(std::string(error.what()).starts_with("fuzz:"));
  }
}

void Check(const algebra::ContactRelation& relation) {
  for (const algebra::Contact& contact : relation.contacts) {
    Require(!contact.planes.empty());
    for (const algebra::Vector3& plane : contact.planes) Require(!plane.IsZero());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  AcceptOrRefuse([&] {
    std::istringstream in(text);
    input::RelationStream relations(in, "fuzz");
    while (const auto relation = relations.Next()) {
      if (const auto* contacts = std::get_if<algebra::ContactRelation>(&*relation)) Check(*contacts);
    }
  });
  AcceptOrRefuse([&] {
    std::istringstream in(text);
    input::ReadDemonstration(in, "fuzz");
  });
  AcceptOrRefuse([&] {
    const auto document = input::JsonDocument::Parse(text, "fuzz");
    Require(IsRotation(input::ParsePose(document.root()).pose.rotation));
  });
  return 0;
}

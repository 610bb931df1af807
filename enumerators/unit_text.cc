#include "enumerators/unit_text.h"

#include "algebra/error.h"
#include "enumerators/run_folder.h"

namespace tact::enumerators {

bool TextReader::Take(std::string_view expected) {
  if (text_.substr(at_, expected.size()) != expected) return false;
  at_ += expected.size();
  return true;
}

void TextReader::Expect(std::string_view expected) {
  if (!Take(expected)) Refuse("'" + std::string(expected) + "'");
}

void TextReader::ExpectEnd() const {
  if (at_ != text_.size()) Refuse("the end");
}

void TextReader::Refuse(const std::string& expected) const {
  throw InputError("byte " + std::to_string(at_ + 1) + " of the counts: expected " + expected + ", got '" +
                   std::string(text_.substr(at_, 20)) + "'");
}

std::string DescribeRun(const std::string& kind, const std::string& version, const std::string& world_name,
                        const ContactWorld& world, uint64_t relations, uint64_t relations_in_a_unit) {
  std::string contacts;
  for (const algebra::Contact& contact : world.contacts) {
    for (const algebra::Vector3& v : {contact.point, contact.planes[0]})
      contacts += v.x.ToString() + " " + v.y.ToString() + " " + v.z.ToString() + "\n";
  }
  return R"({"kind":")" + kind + R"(","version":")" + version + R"(","world":")" + world_name +
         R"(","contacts":)" + std::to_string(world.contacts.size()) + R"(,"contacts_digest":")" +
         Digest(contacts) + R"(","largest":)" + std::to_string(world.largest) + R"(,"relations":)" +
         std::to_string(relations) + R"(,"relations_in_a_unit":)" + std::to_string(relations_in_a_unit) + "}";
}

}  // namespace tact::enumerators

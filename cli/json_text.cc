#include "cli/json_text.h"

#include <fmt/format.h>

namespace tact::cli {
namespace {

template <typename List, typename Print>
std::string Join(const List& list, const Print& print) {
  std::string text = "[";
  for (const auto& item : list) text += (text.size() > 1 ? "," : "") + print(item);
  return text + "]";
}

std::string PlainToJson(const algebra::TranslationDof& dof) {
  return fmt::format(R"({{"maintaining":{},"detaching":{},"constraining":{},"restricted":{}}})",
                     dof.maintaining, dof.detaching, dof.constraining, dof.restricted);
}

std::string RotationToJson(const algebra::RotationDof& dof) {
  return fmt::format(R"({{"maintaining":{},"detaching":{},"detaching_type1":{},"detaching_type2":{},)"
                     R"("constraining":{},"restricted":{}}})",
                     dof.maintaining, dof.detaching, dof.detaching_type1, dof.detaching_type2,
                     dof.constraining, dof.restricted);
}

}  // namespace

std::string JsonString(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string ToJson(const algebra::Rational& value) {
  const std::string text = value.ToDecimal();
  // Readers that take numbers for doubles keep 15 digits.
  constexpr size_t kLongestNumber = 16;
  return text.size() <= kLongestNumber && text.find('/') == std::string::npos
             ? text
             : "\"" + value.ToString() + "\"";
}

std::string ToJson(const algebra::Vector3& v) {
  return "[" + ToJson(v.x) + "," + ToJson(v.y) + "," + ToJson(v.z) + "]";
}

std::string ToJson(const algebra::Contact& contact) {
  std::string text = R"({"point":)" + ToJson(contact.point) + R"(,"planes":)" +
                     Join(contact.planes, [](const algebra::Vector3& n) { return ToJson(n); });
  if (!contact.name.empty()) text += R"(,"name":)" + JsonString(contact.name);
  return text + "}";
}

std::string ContactsToJson(const algebra::ContactRelation& relation) {
  return Join(relation.contacts, [](const algebra::Contact& c) { return ToJson(c); });
}

std::string ToJson(const algebra::MotionDof& dof) {
  return std::string(R"({"singular":)") + (dof.singular ? "true" : "false") + R"(,"translation":)" +
         PlainToJson(dof.translation) + R"(,"rotation":)" + RotationToJson(dof.rotation) + R"(,"all":)" +
         PlainToJson(dof.all) + "}";
}

std::string ToJson(const algebra::DofTransition& t) {
  return R"({"motion":")" + ToString(t.motion) + R"(","from":")" + ToString(t.from) + R"(","to":")" +
         ToString(t.to) + R"("})";
}

}  // namespace tact::cli

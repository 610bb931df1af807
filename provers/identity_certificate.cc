#include "provers/identity_certificate.h"

#include <nlohmann/json.hpp>

namespace tact::provers {
namespace {

using Json = nlohmann::ordered_json;

Json Head(const std::string& claim, const std::string& kind) {
  return Json{{"format", "tact-certificate"}, {"version", 1}, {"claim", claim}, {"kind", kind}};
}

}  // namespace

Certificate IdentityCertificate(const std::string& name, const std::string& claim, const Identity& identity) {
  Json json = Head(claim, "identity");
  json["given"] = identity.given;
  json["equations"] = Json::array();
  for (const Equation& equation : identity.equations) {
    json["equations"].push_back(
        {{"left", equation.left}, {"right", equation.right}, {"cofactors", equation.cofactors}});
  }
  return {name, json.dump() + "\n"};
}

Certificate NoIdentityCertificate(const std::string& name, const std::string& claim,
                                  const NoIdentity& refutation) {
  Json json = Head(claim, "no-identity");
  json["values"] = Json::object();
  for (const auto& [variable, value] : refutation.values) json["values"][variable] = value;
  json["given"] = refutation.given;
  json["left"] = refutation.left;
  json["right"] = refutation.right;
  return {name, json.dump() + "\n"};
}

}  // namespace tact::provers

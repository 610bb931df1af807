/// @file
/// What the certificates about knots share: P-data as JSON, the members that each certificate has. For certificate
/// writers only.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "algebra/knot/p_data.h"

namespace tact::provers {

inline nlohmann::ordered_json CodeJson(const knot::PData& p) {
  return {{"sigma", p.SigmaRow()}, {"attr", p.AttrRow()}};
}

inline nlohmann::ordered_json CertificateHead(const std::string& claim, const std::string& kind) {
  return {{"format", "tact-certificate"}, {"version", 1}, {"claim", claim}, {"kind", kind}};
}

}  // namespace tact::provers

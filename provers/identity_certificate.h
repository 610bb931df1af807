/// @file
/// Polynomial identities, and values that refute one, as certificates (docs/certificates.md).
/// Model   formulas are texts in integers and variables; nothing is checked here: the checker expands them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "provers/certificate.h"

namespace tact::provers {

/// left - right is the sum of the cofactors times what is given, in order.
struct Equation {
  std::string left, right;
  std::vector<std::string> cofactors;
};

struct Identity {
  std::vector<std::string> given;  // each is zero
  std::vector<Equation> equations;
};
Certificate IdentityCertificate(const std::string& name, const std::string& claim, const Identity& identity);

struct NoIdentity {
  std::vector<std::pair<std::string, int>> values;
  std::vector<std::string> given;  // each is zero at the values
  std::string left, right;         // differ there
};
Certificate NoIdentityCertificate(const std::string& name, const std::string& claim,
                                  const NoIdentity& refutation);

}  // namespace tact::provers

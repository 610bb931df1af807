/// @file
/// The claims of [thesis, 5.2 and 5.3], a function a rule; KnotMoveClaims in claims.h has all of them in the thesis' order.
#pragma once

#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

std::vector<Claim> KnotR1CrossRuleClaims();
std::vector<Claim> KnotR2RuleClaims();
std::vector<Claim> KnotR2PlaceClaims();
std::vector<Claim> KnotR3RuleClaims();
/// Propositions 10 to 13, Corollaries 1 and 2.
std::vector<Claim> KnotTriangleClaims();
/// Transitions that several moves or both choices of the selective end explain; Propositions 14 and 15.
std::vector<Claim> KnotAmbiguityClaims();

}  // namespace tact::provers

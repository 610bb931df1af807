/// @file
/// The claims of [thesis, 5.1 and 5.4.1], a function a subject; KnotProjectionClaims in claims.h has all of them.
#pragma once

#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// Definition 6: what reducible P-data consist of, and how projections are put together.
std::vector<Claim> KnotPartClaims();
/// The knot graph, Propositions 7 and 8.
std::vector<Claim> KnotGraphClaims();
/// Proposition 9: how a knot graph lies on a sphere.
std::vector<Claim> KnotEmbeddingClaims();
/// The search for faces and its caution.
std::vector<Claim> KnotFaceClaims();
/// The P-data printed in 5.1 and 5.4.1, and what is said of them.
std::vector<Claim> KnotExampleClaims();

}  // namespace tact::provers

/// @file
/// The claims about optimal trajectories, a file a kind of evidence.
#pragma once

#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// [thesis, A.3, A.4.2, A.6]: what is said of straight lines and of products of turns, as polynomials.
std::vector<Claim> TrajectoryTurnClaims();
/// [thesis, A.2, A.3.2, A.6.1]: which restricted DOFs go with which.
std::vector<Claim> TrajectoryRankClaims();
/// [thesis, A.5, A.6.3]: the peg insertion planned, beside what Ipopt finds.
std::vector<Claim> TrajectoryExampleClaims();

}  // namespace tact::provers

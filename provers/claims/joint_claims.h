/// @file
/// The claims of chapter 4, a file a topic.
#pragma once

#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// [thesis, 4.2 to 4.5.1]: formulas that are not as printed.
std::vector<Claim> JointMisprintClaims();
/// [thesis, 4.2 and 4.3]: identities about turns.
std::vector<Claim> JointTurnClaims();
/// [thesis, 4.3 to 4.6]: identities about axes.
std::vector<Claim> JointAxisClaims();
/// [thesis, 4.5.2], Tables 4.1 and 4.2.
std::vector<Claim> RevoluteTableClaims();
/// [thesis, 4.5.2], what is said about them.
std::vector<Claim> RevoluteScalingClaims();
/// [thesis, 4.5.2], Table 4.3.
std::vector<Claim> PrismaticClaims();
/// [thesis, 4.4.2 and 4.5.2], Table 4.4.
std::vector<Claim> ScrewClaims();
/// [thesis, 4.6.3], the 677 successes of 1000.
std::vector<Claim> TwoAxisClaims();

}  // namespace tact::provers

#include "provers/claims/joint_claims.h"

#include "provers/claims/claims.h"

namespace tact::provers {

std::vector<Claim> JointClaims() {
  std::vector<Claim> all;
  for (auto part : {JointMisprintClaims(), JointTurnClaims(), JointAxisClaims(), RevoluteTableClaims(),
                    RevoluteScalingClaims(), PrismaticClaims(), ScrewClaims(), TwoAxisClaims()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace tact::provers

#include "provers/claims/claims.h"

namespace tact::provers {

std::vector<Claim> AllClaims() {
  std::vector<Claim> all;
  for (auto part : {DisplacementClaims(), PropositionClaims(), MotionDofClaims(), DofClassClaims(),
                    DofTransitionClaims(), SubSkillRuleClaims(), TransitionFrequencyClaims(),
                    SingularClaims(), PegInsertionClaims(), VisionCorrectionClaims(), JointClaims(), PlierClaims(),
                    KnotProjectionClaims(), KnotMoveClaims(), KnotTyingClaims(), KnotWatchedClaims()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace tact::provers

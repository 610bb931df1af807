#include "provers/claims/claims.h"
#include "provers/claims/trajectory_claims.h"

namespace tact::provers {

std::vector<Claim> AllClaims() {
  std::vector<Claim> all;
  for (auto part : {DisplacementClaims(),
                    PropositionClaims(),
                    MotionDofClaims(),
                    DofClassClaims(),
                    DofTransitionClaims(),
                    SubSkillRuleClaims(),
                    TransitionFrequencyClaims(),
                    SingularClaims(),
                    VisionCorrectionClaims(),
                    WatchedInsertionClaims(),
                    PegInsertionClaims(),
                    JointClaims(),
                    PlierClaims(),
                    KnotProjectionClaims(),
                    KnotMoveClaims(),
                    KnotTyingClaims(),
                    KnotWatchedClaims(),
                    TrajectoryRankClaims(),
                    TrajectoryTurnClaims(),
                    TrajectoryExampleClaims()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace tact::provers

#include "provers/claims/knot_move_claims.h"

#include "provers/claims/claims.h"

namespace tact::provers {

std::vector<Claim> KnotMoveClaims() {
  std::vector<Claim> all;
  for (auto part : {KnotR1CrossRuleClaims(), KnotR2RuleClaims(), KnotR2PlaceClaims(), KnotTriangleClaims(),
                    KnotR3RuleClaims(), KnotAmbiguityClaims()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace tact::provers

#include "provers/claims/knot_projection_claims.h"

#include "provers/claims/claims.h"

namespace tact::provers {

std::vector<Claim> KnotProjectionClaims() {
  std::vector<Claim> all;
  for (auto part :
       {KnotPartClaims(), KnotGraphClaims(), KnotEmbeddingClaims(), KnotFaceClaims(), KnotExampleClaims()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace tact::provers

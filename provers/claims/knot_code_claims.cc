#include "provers/claims/claims.h"

namespace tact::provers {

std::vector<Claim> KnotCodeClaims() { return {}; }

}  // namespace tact::provers

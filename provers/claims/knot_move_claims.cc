#include "provers/claims/claims.h"

namespace tact::provers {

std::vector<Claim> KnotMoveClaims() { return {}; }

}  // namespace tact::provers

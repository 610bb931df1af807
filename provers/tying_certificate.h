/// @file
/// A knot tied step by step, as a certificate of kind "knot-tying" (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "algebra/knot/tying.h"
#include "provers/certificate.h"

namespace tact::provers {

/// The object of `tact knot moves --json`, the selective end being the same.
std::string MoveToJson(const knot::Move& move);

/// steps from the straight rope; at_least: so many steps are needed, by the bound of tying_bound.h; 0: not claimed.
Certificate KnotTyingCertificate(const std::string& name, const std::string& claim,
                                 const std::vector<knot::TyingStep>& steps, int at_least = 0);

}  // namespace tact::provers

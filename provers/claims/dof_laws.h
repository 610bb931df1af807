/// @file
/// Laws of the DOF indices that several claims try, as assertions.
#pragma once

#include <string>
#include <vector>

#include "provers/certificate_writer.h"

namespace tact::provers {

/// Maintaining, detaching and constraining DOFs add up to 3, 3 and 6 in translation, rotation and all motion; no detaching
/// DOF is negative.
std::vector<Assertion> SumLaws();

/// The restricted DOF less the detaching and the constraining one compares with zero as `is` says, in
/// translation, rotation and all motion [thesis, 2.6, footnote 1].
std::vector<Assertion> RestrictedLaws(const std::string& is);

}  // namespace tact::provers

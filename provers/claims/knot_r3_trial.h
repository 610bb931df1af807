/// @file
/// The thesis' rule for R_III in all readings, tried in one pass.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algebra/knot/thesis_rules.h"
#include "provers/claims/knot_rule_trial.h"

namespace tact::provers {

struct R3Variant {
  std::string name, file;
  knot::thesis::R3Reading reading;
};
/// From the least to the most that the words may ask for, all in the printed range; then what must be added.
const std::vector<R3Variant>& R3Variants();
/// Places in R3Variants.
inline constexpr size_t kR3Corrected = 4, kR3SignsOnly = 5;

struct R3Trial : RuleTrial {
  long long missed_inside = 0;  // below segment n
  long long wrong_pairs = 0;    // no R3 at all leads from one to the other
};
/// Of each variant. Random ropes are looked at for conclusions only.
const std::vector<R3Trial>& R3TrialsTo(Effort effort);

}  // namespace tact::provers

#include "robot/recognition/contact_estimation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "algebra/error.h"

namespace tact::recognition {
namespace {

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string WhyOf(const NoiseLevel& level, bool by_hand, const std::string& unit) {
  if (by_hand) return "the noise is given by hand";
  if (!level.deviation()) {
    return "the recording tells no noise (the fixed object is not seen, and nothing overlaps), so its poses "
           "are taken "
           "as exact";
  }
  std::string why = "noise of a gap: ";
  if (level.repeatability)
    why += Number(*level.repeatability) + " " + unit + " by the scatter of the fixed object's poses";
  if (level.overlap) {
    why += (level.repeatability ? ", " : "") + Number(*level.overlap) + " " + unit + " by " +
           std::to_string(level.overlaps) + " vertices inside the other solid";
  }
  return why + (level.repeatability && level.overlap ? "; the larger counts" : "");
}

}  // namespace

EstimationRule MakeRule(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                        const ProximitySolid& fixed, const EstimationOptions& options) {
  if ((options.noise && !(*options.noise > 0)) || (options.threshold && !(*options.threshold > 0)))
    throw PreconditionError("a noise or a threshold that is not positive");
  const std::string unit(ToString(recording.models.unit));
  const double span = fixed.diameter();
  const NoiseLevel level = options.noise ? NoiseLevel{} : MeasureNoise(recording, moving, fixed);
  EstimationRule rule;
  rule.noise = std::max(options.noise.value_or(level.deviation().value_or(0)), kLeastNoise * span);
  // Noise as large as the solids leaves nothing to tell.
  const double reward = 2 * std::log(span / (rule.noise * std::sqrt(2 * std::numbers::pi)));
  rule.threshold = options.threshold.value_or(rule.noise * std::sqrt(std::max(reward, 1.0)));
  rule.why = WhyOf(level, options.noise.has_value(), unit) + "; threshold " + Number(rule.threshold) + " " +
             unit +
             (options.threshold ? " by hand" : ", " + Number(rule.threshold / rule.noise) + " deviations");
  return rule;
}

std::vector<NearContact> EstimateContacts(const ProximitySolid& moving, const ProximitySolid& fixed,
                                          const joint::Transform& X_FM, double threshold) {
  return FindNearContacts(moving, fixed, X_FM,
                          {threshold, std::min(2 * threshold / moving.diameter(), std::numbers::pi / 4)});
}

}  // namespace tact::recognition

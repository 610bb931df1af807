/// @file
/// Which elements touch in a noisy pose, as the thesis estimates it: those nearer than a threshold [thesis, 2.7.3].
/// Model   The threshold is chosen from the recording or by hand. The noise's deviation s of a gap comes from the recording
///         (noise_level.h) or by hand. A DOF that a contact takes would lie anywhere in the span w of the fixed solid if
///         nothing touched, so the data speak for the contact with 2 ln(w / (s sqrt(2 pi))), against it with (gap / s)^2.
///         The threshold is where both are equal, some three deviations. Which of these contacts can hold together, and
///         at which pose, is for relation_candidates.h to say.
/// Frames  F; X_FM is the moving solid's pose in it.
/// Units   the solids'.
/// Errors  PreconditionError: a deviation or a threshold that is not positive.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/recognition/near_contacts.h"
#include "robot/recognition/noise_level.h"

namespace tact::recognition {

/// Share of the fixed solid's span: the least noise that is reckoned with, so that exact poses have a threshold, too.
inline constexpr double kLeastNoise = 1e-6;

struct EstimationOptions {
  std::optional<double> noise;      // deviation of a gap; none: measured
  std::optional<double> threshold;  // none: by the rule
};

struct EstimationRule {
  double noise = 0, threshold = 0;
  std::string why;  // a sentence: where these come from
};

/// The rule for a recording; one that tells no noise has the least, and `why` says so.
EstimationRule MakeRule(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                        const ProximitySolid& fixed, const EstimationOptions& options = {});

/// Contacts within the threshold, that could touch if the solid were turned by what moves its farthest vertices so far.
std::vector<NearContact> EstimateContacts(const ProximitySolid& moving, const ProximitySolid& fixed,
                                          const joint::Transform& X_FM, double threshold);

}  // namespace tact::recognition

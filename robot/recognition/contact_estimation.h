/// @file
/// Which elements touch in a noisy pose [thesis, 2.7.3]: those nearer than a threshold, and, where these cannot all be true,
/// ranked candidates of what can hold together.
/// Model   The noise's deviation s of a gap comes from the recording (noise_level.h) or by hand. A DOF that a contact takes
///         would lie anywhere in the span w of the fixed solid if nothing touched, so the data speak for the contact with
///         reward = 2 ln(w / (s sqrt(2 pi))), against it with (way / s)^2. The threshold is where both are equal,
///         s sqrt(reward), some three deviations. A candidate is a set of contacts with a pose near the observed one at which
///         they hold; its cost, smaller is better,
///           (displacement / s)^2 + (overlap / (kOverlap s))^2 - reward * restricted DOFs - kSpare * spare contacts,
///         is minus twice a log likelihood with that penalty on free DOFs (as in Bayesian information criteria). Overlap is
///         how deep the solids still interpenetrate there, at points along their edges: a little may be left to a correction
///         that avoids it, much cannot be. Spare contacts, which take no further DOF, decide between candidates that are alike
///         in all else: parts are made to fit.
/// Model   Candidates grow from the empty one: one near pair more, the nearest pose at which it holds as well, and whatever
///         else holds there. The search is a beam of the kBeam best: what lies outside it is not found.
/// Frames  F; X_FM is the moving solid's pose in it.
/// Units   the solids'.
/// Errors  PreconditionError: a deviation or a threshold that is not positive.
/// Cost    some milliseconds a pose.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/recognition/contact_projection.h"
#include "robot/recognition/noise_level.h"

namespace tact::recognition {

/// Candidates that are grown further at once: the relations of one pose of the recorded peg number a few dozen.
inline constexpr size_t kBeam = 12;
/// Share of the noise that overlap is weighed by.
inline constexpr double kOverlap = 0.2;
/// What a spare contact is worth, in squared deviations: fifteen of them, a seated peg's, as much as one deviation and a
/// fifth.
inline constexpr double kSpare = 0.1;
/// Points an edge is divided by to find overlap: at its ends alone, a rim that lies a little beyond the other solid's would be
/// missed.
inline constexpr int kEdgeParts = 6;
/// Share of the fixed solid's span: the least noise that is reckoned with, so that exact poses have a threshold, too.
inline constexpr double kLeastNoise = 1e-6;

struct EstimationOptions {
  std::optional<double> noise;      // deviation of a gap; none: measured
  std::optional<double> threshold;  // none: by the rule
};

struct EstimationRule {
  double noise = 0, threshold = 0, reward = 0;
  std::string why;  // a sentence: where these come from
};

/// The rule for a recording; one that tells no noise has the least, and `why` says so.
EstimationRule MakeRule(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                        const ProximitySolid& fixed, const EstimationOptions& options = {});

struct ContactCandidate {
  std::vector<PointContact> contacts;  // sorted
  joint::Transform X_FM;               // at which they hold
  double displacement = 0;             // from the observed pose
  double overlap = 0;                  // left at X_FM
  int restricted = 0;                  // DOFs taken
  double cost = 0;
};

struct SceneEstimate {
  std::vector<NearPair> near;                // below the threshold
  std::vector<ContactCandidate> candidates;  // best first; the empty one is among them
};

/// At most `most` candidates.
SceneEstimate EstimateContacts(const ProximitySolid& moving, const ProximitySolid& fixed,
                               const joint::Transform& X_FM, const EstimationRule& rule, size_t most = 8);

}  // namespace tact::recognition

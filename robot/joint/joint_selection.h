/// @file
/// Which type of joint the poses show, or why they cannot tell.
/// Model   Each type's marginal likelihood with the coordinates as normal random effects (coordinate_spread.h), so that types with
///         many coordinates and with few compare fairly; BIC with the parameters, two scales, and the coordinates' mean and
///         covariance counted; the sample size is the effective one of autocorrelated residuals. Types within kPlausible of the
///         best are plausible; the answer is the plausible type that all other plausible ones generalise. If there is
///         none, or it was not exercised enough, the answer is open.
/// Exact   no.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/joint/robust.h"

namespace tact::joint {

inline constexpr double kPlausible = 6;  // of BIC: the usual "strong evidence"

/// Whether every set of poses that a joint of the special type allows is one that some joint of the general type allows (as a
/// limit: a screw of large pitch, a revolute axis far away). True for a type and itself.
bool Generalises(JointType general, JointType special);

struct TypeScore {
  RobustFit robust;           // of the type robust.fit.joint.type
  double log_likelihood = 0;  // of all poses, nat
  int parameters = 0;         // counted by BIC
  double bic = 0;
  bool plausible = false;
};

struct SelectionOptions {
  bool robust = true;  // false: every pose is right
  RobustOptions consensus;
};

struct JointSelection {
  std::optional<JointType> type;      // none: the poses cannot tell
  std::vector<TypeScore> scores;      // in the order of kJointTypes; only of types with enough poses
  std::vector<JointType> candidates;  // plausible ones, best first
  double effective_poses = 0;
  std::string reason;  // one sentence, why this type or why none
};

/// Pre: poses not empty and finite.
JointSelection SelectJoint(std::span<const Transform> poses, const SelectionOptions& options = {});

}  // namespace tact::joint

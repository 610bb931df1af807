/// @file
/// Which type of joint the poses show, or why they cannot tell.
/// Model   Each type's marginal likelihood with the coordinates as normal random effects (coordinate_spread.h), so that
///         types with many coordinates and with few compare fairly; BIC with the parameters, two scales, the
///         coordinates' mean and covariance counted. A tracker's errors follow one another (residuals correlate over
///         `correlation` poses), so N poses weigh like N / correlation, and covariances are that much larger; they also
///         bend smoothly what it sees, which no number of poses averages out and a joint with more freedom takes for
///         motion: the noise is taken as at least SelectionOptions::bending, as far as residuals correlate. Types within
///         kPlausible of the best are plausible. The answer is the plausible type that all other plausible ones
///         generalise; prismatic only if no circle of an everyday radius would do as well. Otherwise it is open.
/// Exact   no.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/joint/robust.h"

namespace tact::joint {

inline constexpr int kFewestPoses = 5;
inline constexpr double kLeastRadius = 2;  // metre: few things turn about an axis farther away
inline constexpr double kPlausible = 6;    // of BIC: the usual "strong evidence"

/// Whether every set of poses that a joint of the special type allows is one that some joint of the general type allows
/// (as a limit: a screw of large pitch, a revolute axis far away). True for a type and itself.
bool Generalises(JointType general, JointType special);

struct TypeScore {
  JointType type = JointType::kRigid;
  RobustFit robust;
  double log_likelihood = 0;  // of all poses, nat
  int parameters = 0;         // counted by BIC
  double bic = 0;
  bool plausible = false;
};

struct SelectionOptions {
  RobustOptions robust;
  // Root mean square of a component: a camera's calibration, a marker's own errors.
  NoiseScale bending{0.02, 0.003};
};

struct JointSelection {
  std::optional<JointType> type;      // none: the poses cannot tell
  std::vector<TypeScore> scores;      // in the order of kJointTypes; none if too few poses
  std::vector<JointType> candidates;  // plausible ones, best first
  double correlation = 1;             // over how many poses residuals repeat themselves
  std::string reason;                 // one sentence, why this type or why none
};

/// Pre: poses not empty and finite.
JointSelection SelectJoint(std::span<const Transform> poses, const SelectionOptions& options = {});

}  // namespace tact::joint

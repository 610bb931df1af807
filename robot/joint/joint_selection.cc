#include "robot/joint/joint_selection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "robot/joint/joint_parameters.h"
#include "robot/joint/residual_correlation.h"

namespace tact::joint {
namespace {

using Poses = std::span<const Transform>;

constexpr double kSamePose = 1e-12;  // radian, metre: below what any file tells apart

// Parameters that BIC counts: the joint's, two scales, the coordinates' mean and covariance.
int CountedParameters(JointType type) {
  const int dof = JointDof(type);
  return JointParameters(type) + 2 + dof + dof * (dof + 1) / 2;
}

bool AllTheSame(Poses poses) {
  return std::all_of(poses.begin(), poses.end(), [&poses](const Transform& X_BA) {
    return (X_BA.R - poses.front().R).norm() < kSamePose && (X_BA.p - poses.front().p).norm() < kSamePose;
  });
}

std::vector<TypeScore> ScoresOf(Poses poses, const RobustOptions& options) {
  std::vector<TypeScore> scores;
  for (const JointType type : kJointTypes) {
    TypeScore score;
    score.type = type;
    score.parameters = CountedParameters(type);
    score.robust = FitRobustly(type, poses, options);
    score.log_likelihood = score.robust.log_likelihood;
    scores.push_back(std::move(score));
  }
  return scores;
}

// The largest curvature (one by radius) of A's origin's path that the poses leave likely.
double CurvatureBound(const RobustFit& revolute, const Transform& reference) {
  for (const NamedParameter& parameter : NamedParametersOf(revolute.fit, reference)) {
    if (parameter.kind != ParameterKind::kPoint || parameter.frame != Link::kA) continue;
    const double radius = parameter.value.head<3>().norm();
    return 1 / radius + 2 * parameter.expected_error / (radius * radius);
  }
  return 0;
}

std::string ListOf(const std::vector<JointType>& types) {
  std::string list;
  for (const JointType type : types) list += (list.empty() ? "" : ", ") + std::string(NameOf(type));
  return list;
}

const TypeScore& ScoreOf(const JointSelection& selection, JointType type) {
  return selection.scores[static_cast<std::size_t>(type)];
}

void Decide(JointSelection& selection, Poses poses) {
  const std::vector<JointType>& candidates = selection.candidates;
  const auto special = std::find_if(candidates.begin(), candidates.end(), [&candidates](JointType type) {
    return std::all_of(candidates.begin(), candidates.end(),
                       [type](JointType t) { return Generalises(t, type); });
  });
  if (special == candidates.end()) {
    selection.reason = "the motion seen is too little to tell apart: " + ListOf(candidates);
    return;
  }
  const TypeScore& revolute = ScoreOf(selection, JointType::kRevolute);
  if (*special == JointType::kPrismatic && revolute.plausible &&
      CurvatureBound(revolute.robust, poses.front()) > 1 / kLeastRadius) {
    selection.reason =
        "the motion seen is too little to tell a straight path from a circle's: " + ListOf(candidates);
    return;
  }
  selection.type = *special;
  if (*special == JointType::kRigid) {
    selection.reason = "no motion beyond the noise; a joint held still looks the same";
  } else if (candidates.size() == 1) {
    selection.reason = "no other type explains the poses nearly as well";
  } else {
    std::vector<JointType> others = candidates;
    std::erase(others, *special);
    selection.reason =
        "the simplest type that explains the poses; the others in reach contain it: " + ListOf(others);
  }
}

}  // namespace

bool Generalises(JointType general, JointType special) {
  using enum JointType;
  if (general == special || special == kRigid) return true;
  if (general == kRigid) return false;
  if (special == kPrismatic) return true;
  if (special == kRevolute) return general != kPrismatic;
  if (special == kScrew) return general == kCylindrical;
  return false;
}

JointSelection SelectJoint(Poses poses, const SelectionOptions& options) {
  JointSelection selection;
  const bool few = poses.size() < static_cast<std::size_t>(kFewestPoses);
  if (few || AllTheSame(poses)) {
    selection.candidates.assign(kJointTypes.begin(), kJointTypes.end());
    selection.reason = few ? "too few poses: " + std::to_string(poses.size()) + ", at least " +
                                 std::to_string(kFewestPoses) + " are needed"
                           : "all poses are the same one";
    return selection;
  }
  selection.scores = ScoresOf(poses, options.robust);
  const auto best = std::max_element(
      selection.scores.begin(), selection.scores.end(),
      [](const TypeScore& a, const TypeScore& b) { return a.log_likelihood < b.log_likelihood; });
  selection.correlation = ResidualCorrelation(best->robust.fit, poses, best->robust.weights);
  if (selection.correlation > 1) {
    const double share = std::sqrt(1 - 1 / selection.correlation);
    RobustOptions robust = options.robust;
    robust.least_noise = {share * options.bending.rotation, share * options.bending.translation};
    selection.scores = ScoresOf(poses, robust);
  }
  const double effective = static_cast<double>(poses.size()) / selection.correlation;
  for (TypeScore& score : selection.scores) {
    score.bic = -2 * score.log_likelihood / selection.correlation + score.parameters * std::log(effective);
    score.robust.fit.covariance *= selection.correlation;
    score.robust.fit.information /= selection.correlation;
  }
  std::vector<const TypeScore*> order;
  for (const TypeScore& score : selection.scores) order.push_back(&score);
  std::sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->bic < b->bic; });
  for (const TypeScore* score : order) {
    if (score->bic > order.front()->bic + kPlausible) break;
    selection.candidates.push_back(score->type);
  }
  for (const JointType type : selection.candidates)
    selection.scores[static_cast<std::size_t>(type)].plausible = true;
  Decide(selection, poses);
  return selection;
}

}  // namespace tact::joint

#include "robot/joint/joint_selection.h"

#include <algorithm>
#include <cmath>

#include "robot/joint/joint_parameters.h"

namespace tact::joint {
namespace {

using Poses = std::span<const Transform>;

constexpr int kScales = 2;

// Parameters that BIC counts: the joint's, the scales, the coordinates' mean and covariance.
int CountedParameters(JointType type) {
  const int dof = JointDof(type);
  return JointParameters(type) + kScales + dof + dof * (dof + 1) / 2;
}

// The correlation of one pose's residual with the next one's.
double Autocorrelation(const RobustFit& robust, Poses poses) {
  const std::vector<Residual> residuals = ResidualsOf(robust.fit, poses);
  const NoiseScale& noise = robust.fit.noise;
  double product = 0, square = 0;
  for (std::size_t i = 1; i < residuals.size(); ++i) {
    if (robust.weights[i] < 0.5 || robust.weights[i - 1] < 0.5) continue;
    const Residual &a = residuals[i - 1], &b = residuals[i];
    const double turn = 1 / (noise.rotation * noise.rotation),
                 move = 1 / (noise.translation * noise.translation);
    product += turn * a.rotation.dot(b.rotation) + move * a.translation.dot(b.translation);
    square += turn * b.rotation.squaredNorm() + move * b.translation.squaredNorm();
  }
  return square > 0 ? std::clamp(product / square, 0.0, 0.99) : 0;
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
  for (const JointType type : kJointTypes) {
    TypeScore score;
    score.robust = FitRobustly(type, poses, options.consensus);
    score.parameters = CountedParameters(type);
    score.log_likelihood = score.robust.log_likelihood;
    selection.scores.push_back(score);
  }
  const auto best = std::max_element(selection.scores.begin(), selection.scores.end(),
                                     [](auto& a, auto& b) { return a.log_likelihood < b.log_likelihood; });
  const double rho = Autocorrelation(best->robust, poses);
  const double share = (1 - rho) / (1 + rho);
  selection.effective_poses = share * static_cast<double>(poses.size());
  for (TypeScore& score : selection.scores)
    score.bic = -2 * share * score.log_likelihood + score.parameters * std::log(selection.effective_poses);
  double least = 1e300;
  for (TypeScore& score : selection.scores) least = std::min(least, score.bic);
  for (TypeScore& score : selection.scores) {
    score.plausible = score.bic < least + kPlausible;
    if (score.bic == least) selection.type = score.robust.fit.joint.type;
  }
  return selection;
}

}  // namespace tact::joint

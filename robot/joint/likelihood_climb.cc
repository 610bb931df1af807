#include "robot/joint/likelihood_climb.h"

#include <algorithm>
#include <cmath>

#include "robot/joint/least_squares.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Poses = std::span<const Transform>;
using Weights = std::span<const double>;

constexpr double kSmallestScale = 1e-12;  // radian, metre: noise-free data stay solvable in doubles
// Where the start leaves no error of orientation at all (spherical), a usual scale to begin with, in radian.
constexpr double kFirstRotation = 0.01;
constexpr double kSettledSquares = 1e-10, kSettledScale = 1e-4;  // relative changes that end the climb

double WeightOf(Weights weights, std::size_t i) { return weights.empty() ? 1 : weights[i]; }

NoiseScale FirstScale(const Joint& joint, const std::vector<Coordinates>& q, Poses poses, Weights weights) {
  double rotation = 0, translation = 0, count = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector6 error = PoseError(joint, q[i], poses[i]);
    rotation += WeightOf(weights, i) * error.head<3>().squaredNorm();
    translation += WeightOf(weights, i) * error.tail<3>().squaredNorm();
    count += 3 * WeightOf(weights, i);
  }
  const bool turns_freely = joint.type == JointType::kSpherical;
  return {turns_freely ? kFirstRotation : std::sqrt(rotation / count), std::sqrt(translation / count)};
}

}  // namespace

std::vector<Coordinates> CoordinatesAlong(const Joint& joint, Poses poses, Weights weights) {
  std::vector<Coordinates> along;
  along.reserve(poses.size());
  Coordinates previous = Coordinates::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Coordinates q = CoordinatesNear(joint, poses[i]);
    for (int k = 0; k < UnboundedAngles(joint.type); ++k) q[k] = ContinuousWith(q[k], previous[k]);
    if (WeightOf(weights, i) >= 0.5) previous = q;
    along.push_back(q);
  }
  return along;
}

LikelihoodClimb::LikelihoodClimb(const Joint& start, Poses poses, std::optional<NoiseScale> noise,
                                 Weights weights, const NoiseScale& least)
    : poses_(poses),
      scales_known_(noise.has_value()),
      least_{std::max(kSmallestScale, least.rotation), std::max(kSmallestScale, least.translation)},
      tried_(start) {
  fit_.joint = start;
  fit_.coordinates = CoordinatesAlong(start, poses, weights);
  fit_.noise = noise ? *noise : FirstScale(start, fit_.coordinates, poses, weights);
  if (!noise) {
    fit_.noise.rotation = std::max(least_.rotation, fit_.noise.rotation);
    fit_.noise.translation = std::max(least_.translation, fit_.noise.translation);
  }
  tried_coordinates_.resize(poses.size());
  equations_.resize(poses.size());
  tried_equations_.resize(poses.size());
}

void LikelihoodClimb::Step(Weights weights) {
  ++fit_.iterations;
  const int dof = JointDof(tried_.type);
  NormalEquations normal(JointParameters(tried_.type));
  double now = 0, before = 0;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    PoseEquations& pose = tried_equations_[i];
    pose = EquationsAt(tried_, fit_.coordinates[i], poses_[i], fit_.noise);
    tried_coordinates_[i] = Changed(tried_, fit_.coordinates[i], pose.step);
    const double weight = WeightOf(weights, i);
    normal.Add(pose, dof, weight);
    now += weight * pose.Squares();
    if (any_) {
      // The accepted joint's squares, in units of the scales of now.
      const Vector6& old = equations_[i].error;
      before += weight * (old.head<3>().squaredNorm() + old.tail<3>().squaredNorm());
    }
  }
  const bool better = !any_ || now <= before * (1 + 1e-12);
  if (!better) {
    damping_ = std::max(1e-4, 10 * damping_);
    fit_.converged = damping_ > 1e8;
    Propose();
    return;
  }
  fit_.joint = tried_;
  fit_.coordinates.swap(tried_coordinates_);
  equations_.swap(tried_equations_);
  fit_.information = normal.Information();
  fit_.covariance = PseudoInverse(fit_.information, 1e-12, &fit_.rank);
  fit_.squares = now;
  gradient_ = normal.gradient;
  damping_ = damping_ < 1e-6 ? 0 : damping_ / 10;
  fit_.converged = any_ && before - now <= kSettledSquares * before;
  any_ = true;
  if (!scales_known_) {
    const std::array<double, 2> factors = ScaleFactors(normal, fit_.covariance);
    NoiseScale next{std::max(least_.rotation, fit_.noise.rotation * factors[0]),
                    std::max(least_.translation, fit_.noise.translation * factors[1])};
    const double turn = fit_.noise.rotation / next.rotation, move = fit_.noise.translation / next.translation;
    if (std::abs(turn - 1) > kSettledScale || std::abs(move - 1) > kSettledScale) fit_.converged = false;
    for (PoseEquations& pose : equations_) pose.error.head<3>() *= turn, pose.error.tail<3>() *= move;
    fit_.noise = next;
  }
  Propose();
}

void LikelihoodClimb::Propose() {
  ParameterMatrix damped = fit_.information;
  damped.diagonal() *= 1 + damping_;
  const ParameterVector step = PseudoInverse(damped, 1e-12) * gradient_;
  tried_ = Changed(fit_.joint, step);
}

}  // namespace tact::joint

/// @file
/// The climb of maximum_likelihood.h step by step, for those who change the weights on the way (robust.h).
/// Model   Levenberg and Marquardt: a step that raises the sum of squares is taken back and tried again, shorter.
#pragma once

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

class LikelihoodClimb {
 public:
  /// noise: known, or none to estimate it, as no less than `least`.
  LikelihoodClimb(const Joint& start, std::span<const Transform> poses, std::optional<NoiseScale> noise,
                  std::span<const double> weights, const NoiseScale& least = {});

  /// Evaluates the joint tried last and, if it is better, goes there. weights: empty, or of each pose.
  void Step(std::span<const double> weights);

  const JointFit& fit() const { return fit_; }
  JointFit&& Take() { return std::move(fit_); }
  /// Of the accepted joint, before the last change of the scales.
  const std::vector<PoseEquations>& equations() const { return equations_; }

 private:
  void Propose();

  std::span<const Transform> poses_;
  bool scales_known_;
  NoiseScale least_;
  JointFit fit_;
  Joint tried_;
  std::vector<PoseEquations> equations_, tried_equations_;
  std::vector<Coordinates> tried_coordinates_;
  ParameterVector gradient_;
  double damping_ = 0;
  bool any_ = false;
};

/// Coordinates of all poses, angles continuous along those that count at least half.
std::vector<Coordinates> CoordinatesAlong(const Joint& joint, std::span<const Transform> poses,
                                          std::span<const double> weights = {});

}  // namespace tact::joint

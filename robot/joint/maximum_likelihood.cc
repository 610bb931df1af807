#include "robot/joint/maximum_likelihood.h"

#include <cmath>

#include "robot/joint/joint_gauge.h"
#include "robot/joint/least_squares.h"
#include "robot/joint/likelihood_climb.h"

namespace tact::joint {

JointFit ClimbLikelihood(const Joint& start, std::span<const Transform> poses, const FitOptions& options) {
  LikelihoodClimb climb(start, poses, options.noise, options.weights);
  while (!climb.fit().converged && climb.fit().iterations < options.most_iterations)
    climb.Step(options.weights);
  return climb.Take();
}

JointFit FitMaximumLikelihood(JointType type, std::span<const Transform> poses, const FitOptions& options) {
  std::optional<JointFit> best;
  for (const Joint& start : StartsOf(type, poses)) {
    JointFit fit = ClimbLikelihood(InNormalForm(start, poses), poses, options);
    const auto spread = [](const JointFit& f) {
      return std::log(f.noise.rotation) + std::log(f.noise.translation);
    };
    const bool better = !best || (options.noise ? fit.squares < best->squares : spread(fit) < spread(*best));
    if (better) best = std::move(fit);
  }
  return *best;
}

}  // namespace tact::joint

#include "robot/joint/robust.h"

#include <algorithm>
#include <cmath>

#include "robot/joint/consensus.h"
#include "robot/joint/coordinate_spread.h"
#include "robot/joint/joint_gauge.h"
#include "robot/joint/likelihood_climb.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Poses = std::span<const Transform>;

constexpr double kMostWrong = 0.5;  // of all poses
constexpr double kSettledWeight = 1e-3;
constexpr int kMostIterations = 100;

struct Expectation {
  std::vector<double> weights;
  double share_wrong = 0, log_likelihood = 0, largest_change = 0;
};

Expectation Expect(const JointFit& fit, std::span<const PoseEquations> equations, const Expectation& last,
                   double log_anywhere) {
  const CoordinateSpread spread =
      SpreadOf(JointDof(fit.joint.type), fit.coordinates, equations, last.weights);
  Expectation next = last;
  next.log_likelihood = next.largest_change = 0;
  double right = 0;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const double density = LogDensity(spread, fit.joint.type, fit.coordinates[i], equations[i], fit.noise);
    const double odds = std::log(last.share_wrong / (1 - last.share_wrong)) + log_anywhere - density;
    next.weights[i] = 1 / (1 + std::exp(odds));
    next.log_likelihood += LogMixture(density, log_anywhere, last.share_wrong);
    next.largest_change = std::max(next.largest_change, std::abs(next.weights[i] - last.weights[i]));
    right += next.weights[i];
  }
  const auto count = static_cast<double>(equations.size());
  // One wrong pose more than seen, of as many more: a share of zero would never see one.
  next.share_wrong = std::min(kMostWrong, (count - right + 0.5) / (count + 1));
  return next;
}

// Bread from the observed information of the mixture, meat from the poses' own gradients.
void SetSandwich(JointFit& fit, std::span<const PoseEquations> equations, std::span<const double> weights) {
  ParameterMatrix bread = fit.information;
  ParameterMatrix meat = ParameterMatrix::Zero(bread.rows(), bread.cols());
  double count = 0;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const ParameterVector gradient = equations[i].parameters.transpose() * equations[i].error;
    bread.noalias() -= weights[i] * (1 - weights[i]) * gradient * gradient.transpose();
    meat.noalias() += weights[i] * weights[i] * gradient * gradient.transpose();
    count += weights[i];
  }
  const ParameterMatrix inverse = PseudoInverse(bread);
  // The inverse of a covariance estimated from few gradients is too large on average (Wishart's), by this factor.
  const double few = count / std::max(1.0, count - static_cast<double>(bread.rows()) - 1);
  fit.covariance = few * inverse * meat * inverse;
}

}  // namespace

RobustFit FitRobustly(JointType type, Poses poses, const RobustOptions& options) {
  const Consensus start = FindConsensus(type, poses, options.samples, options.seed);
  std::vector<Transform> near;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (start.weights[i] > 0) near.push_back(poses[i]);
  }
  LikelihoodClimb climb(InNormalForm(start.joint, near), poses, std::nullopt, start.weights,
                        options.least_noise);
  const double log_anywhere = LogAnywhere(poses);
  Expectation expectation{start.weights, 0.2, 0, 1};
  climb.Step(expectation.weights);
  do {
    expectation = Expect(climb.fit(), climb.equations(), expectation, log_anywhere);
    climb.Step(expectation.weights);
  } while ((!climb.fit().converged || expectation.largest_change > kSettledWeight) &&
           climb.fit().iterations < kMostIterations);
  RobustFit robust{{}, expectation.weights, {}, expectation.share_wrong, expectation.log_likelihood};
  const std::vector<PoseEquations> equations = climb.equations();
  robust.fit = climb.Take();
  SetSandwich(robust.fit, equations, robust.weights);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (robust.weights[i] < 0.5) robust.outliers.push_back(i);
  }
  return robust;
}

}  // namespace tact::joint

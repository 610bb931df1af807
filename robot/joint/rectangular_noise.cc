#include "robot/joint/rectangular_noise.h"

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "algebra/error.h"
#include "robot/joint/likelihood_climb.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

constexpr double kFirstBound = 1.02;  // times the least bounds at the fit
constexpr double kAccepted =
    0.25;  // the share of proposals that the adaption aims at (Roberts and Rosenthal)

// Normal numbers that every machine draws alike.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double Uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  double Normal() { return std::sqrt(-2 * std::log(Uniform())) * std::cos(2 * std::numbers::pi * Uniform()); }

 private:
  std::mt19937_64 engine_;
};

// Mean and covariance as samples come in.
struct Running {
  double count = 0;
  SmallVector mean;
  SmallMatrix squares;

  explicit Running(Eigen::Index size)
      : mean(SmallVector::Zero(size)), squares(SmallMatrix::Zero(size, size)) {}
  void Add(const SmallVector& value) {
    count += 1;
    const SmallVector before = value - mean;
    mean += before / count;
    squares.noalias() += before * (value - mean).transpose();
  }
  SmallMatrix Covariance() const { return squares / std::max(1.0, count - 1); }
};

// The state: changes of the parameters and, if they are estimated, of the bounds' logarithms.
class Chain {
 public:
  Chain(const RectangularLikelihood& likelihood, const ParameterMatrix& covariance, const NoiseBounds& bounds,
        bool bounds_known, std::uint64_t seed)
      : likelihood_(likelihood), bounds_(bounds), parameters_(covariance.rows()), draw_(seed) {
    const Eigen::Index size = parameters_ + (bounds_known ? 0 : 2);
    SmallMatrix first = SmallMatrix::Zero(size, size);
    first.topLeftCorner(parameters_, parameters_) = covariance;
    for (Eigen::Index i = parameters_; i < size; ++i) first(i, i) = 1e-4;
    root_ = SquareRoot(first);
    state_ = SmallVector::Zero(size);
    value_ = Value(state_);
    scale_ = 1 / std::sqrt(static_cast<double>(size));
  }
  bool Step(bool adapt) {
    SmallVector noise(state_.size());
    for (double& entry : noise) entry = draw_.Normal();
    const SmallVector proposed = state_ + scale_ * (root_ * noise);
    const double value = Value(proposed);
    const bool accepted = std::log(draw_.Uniform()) < value - value_;
    if (accepted) state_ = proposed, value_ = value;
    if (adapt) scale_ *= std::exp(0.02 * ((accepted ? 1 : 0) - kAccepted));
    return accepted;
  }
  void Propose(const SmallMatrix& covariance) {
    root_ = SquareRoot(covariance);
    scale_ = 2 / std::sqrt(static_cast<double>(state_.size()));
  }
  const SmallVector& state() const { return state_; }
  double value() const { return value_; }
  NoiseBounds BoundsAt(const SmallVector& state) const {
    if (state.size() == parameters_) return bounds_;
    return {bounds_.rotation * std::exp(state[parameters_]),
            bounds_.translation * std::exp(state[parameters_ + 1])};
  }

 private:
  double Value(const SmallVector& state) const {
    return likelihood_.At(state.head(parameters_), BoundsAt(state));
  }

  const RectangularLikelihood& likelihood_;
  NoiseBounds bounds_;
  Eigen::Index parameters_;
  Draw draw_;
  SmallMatrix root_;
  SmallVector state_;
  double value_ = 0, scale_ = 1;
};

// A sample around the fit's joint, whose mean becomes the joint.
void Sample(PosteriorMean& posterior, std::span<const Transform> poses, bool bounds_known, int samples,
            std::uint64_t seed) {
  const RectangularLikelihood likelihood(posterior.fit, poses);
  if (!bounds_known) {
    const NoiseBounds least = likelihood.LeastBounds();
    posterior.bounds = {kFirstBound * least.rotation, kFirstBound * least.translation};
  }
  Chain chain(likelihood, posterior.fit.covariance, posterior.bounds, bounds_known, seed);
  Running early(chain.state().size()), late = early;
  int accepted = 0;
  const int half = samples / 2, quarter = samples / 4;
  for (int i = 0; i < samples; ++i) {
    if (i == half) chain.Propose(early.Covariance());
    const bool moved = chain.Step(i < half + quarter / 2);
    if (i >= quarter && i < half) early.Add(chain.state());
    if (i < half + quarter / 2) continue;
    late.Add(chain.state());
    accepted += moved;
  }
  const Eigen::Index parameters = posterior.fit.covariance.rows();
  posterior.acceptance = accepted / late.count;
  posterior.bounds = chain.BoundsAt(late.mean);
  posterior.outside = likelihood.PosesOutside(late.mean.head(parameters), posterior.bounds);
  posterior.fit.joint = Changed(posterior.fit.joint, late.mean.head(parameters));
  posterior.fit.covariance = late.Covariance().topLeftCorner(parameters, parameters);
  posterior.fit.information = PseudoInverse(posterior.fit.covariance);
  posterior.fit.coordinates = CoordinatesAlong(posterior.fit.joint, poses);
}

}  // namespace

PosteriorMean FitPosteriorMean(JointType type, std::span<const Transform> poses,
                               const PosteriorOptions& options) {
  if (JointDof(type) > 1) {
    throw PreconditionError("posterior mean: a " + std::string(NameOf(type)) +
                            " joint has more than one DOF; use maximum likelihood");
  }
  PosteriorMean posterior;
  posterior.fit = FitMaximumLikelihood(type, poses);
  if (options.bounds) posterior.bounds = *options.bounds;
  Sample(posterior, poses, options.bounds.has_value(), options.samples, options.seed);
  // The squared length of a uniform error has the mean bound^2 / 3, a third of it a component.
  posterior.fit.noise = {posterior.bounds.rotation / 3, posterior.bounds.translation / 3};
  return posterior;
}

}  // namespace tact::joint

/// @file
/// The thesis' noise law: errors of uniform length, in any direction, up to a bound [thesis, 4.5.2].
/// Model   An error of orientation has the density 1 / (4 pi b |w|^2) for |w| < b, one of location alike: a pole at
///         zero and a sharp edge, both of which tell more than a Gaussian would. A pose's own coordinate q is
///         integrated out in closed form: along q the errors are w - x z and d - x m, so the integrand is 1 / ((x^2 +
///         A^2) ((x - x0)^2 + C^2)) by partial fractions, over the x that keep both inside their bounds. Errors are
///         linear in the parameters, which holds near a fit.
/// Units   radian, metre.
/// Cost    some 100 ns a pose.
#pragma once

#include <span>
#include <vector>

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

/// Largest errors.
struct NoiseBounds {
  double rotation = 0;
  double translation = 0;
};

class RectangularLikelihood {
 public:
  /// Around a fit of a type of at most one DOF.
  RectangularLikelihood(const JointFit& fit, std::span<const Transform> poses);

  /// Log likelihood up to a constant, after a change of the parameters. Where poses lie outside the bounds it is not
  /// minus infinity but falls with how far they do, so that a search finds back.
  double At(const ParameterVector& change, const NoiseBounds& bounds) const;

  /// How many poses lie outside the bounds whatever their coordinate.
  std::size_t PosesOutside(const ParameterVector& change, const NoiseBounds& bounds) const;

  /// The bounds that just hold all poses at the fit.
  NoiseBounds LeastBounds() const { return least_; }

 private:
  struct Pose {
    Vector6 error;
    ParameterJacobian parameters;
    Eigen::Vector3d z, m;  // what a unit of the coordinate does to both errors
  };
  static double LogOf(const Pose& pose, const ParameterVector& change, const NoiseBounds& bounds);

  std::vector<Pose> poses_;
  NoiseBounds least_;
};

}  // namespace tact::joint

/// @file
/// Minima by nonlinear conjugate gradients, as textbooks have them [Fletcher and Reeves 1964, Polak and Ribiere 1969].
/// Model   d_0 = -g_0; x_{k+1} = x_k + t_k d_k, t_k by a line search; d_{k+1} = -g_{k+1} + b_k d_k with
///           Fletcher-Reeves   b_k = |g_{k+1}|^2 / |g_k|^2
///           Polak-Ribiere     b_k = max(0, g_{k+1} . (g_{k+1} - g_k) / |g_k|^2).
///         Every n steps, n the number of unknowns, and where d is no descent, it starts again along -g. The line
///         search brackets a zero of the slope by doubling a first step and closes in by secants: the first minimum it
///         meets, or one behind.
/// Errors  none: not converged is an answer.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace tact::joint {

using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
/// The value; sets the gradient.
using Objective = std::function<double(const Unknowns& x, Unknowns* gradient)>;

enum class CgUpdate { kFletcherReeves, kPolakRibiere };

struct CgOptions {
  CgUpdate update = CgUpdate::kPolakRibiere;
  double first_step = 0.1;   // the length that the line search tries first; 0: the direction's own
  double tolerance = 1e-12;  // of a step's decrease of the value, relative to it, at which it is done
  int most_iterations = 500;
};

struct CgMinimum {
  Unknowns x;
  double value = 0;
  int iterations = 0;
  bool converged = false;
};

CgMinimum MinimizeByConjugateGradient(const Objective& objective, Unknowns start,
                                      const CgOptions& options = {});

}  // namespace tact::joint

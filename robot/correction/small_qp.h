/// @file
/// Strictly convex quadratic programmes in a few variables.
/// Model   min x . B x / 2 + g . x with E x = e and C x + s >= c, 0 <= s paid for by `weight` * s: the largest violation of
///         the inequalities is a variable, so that there is always an answer; s is 0 wherever the inequalities can hold
///         and their multipliers sum to less than the weight. Equalities by an orthonormal basis of their null space, the
///         rest by the dual active set method [Goldfarb and Idnani 1983].
/// Shapes  B is n x n, E is m x n of full rank, C is k x n.
/// Errors  InvariantError: B is not positive definite where the equalities hold.
/// Cost    O(n^3) a change of the active set.
#pragma once

#include <Eigen/Core>

namespace tact::correction {

struct SmallQp {
  Eigen::MatrixXd B, E, C;
  Eigen::VectorXd g, e, c;
  double weight = 1;
};

struct SmallQpAnswer {
  Eigen::VectorXd x;
  double violation = 0;                      // s
  Eigen::VectorXd equalities, inequalities;  // multipliers: B x + g = E' equalities + C' inequalities
  bool ended = true;                         // false: the limit of changes was met, x is no optimum
};

/// Violations up to `tolerance` count as none.
SmallQpAnswer Solve(const SmallQp& qp, double tolerance);

}  // namespace tact::correction

/// @file
/// The two axes of a joint of restricted DOF one in rotation, without an initial guess.
/// Model   u in B, v in A, unit: the least sum of (u . R_i v)^2 [thesis, eq. (4.38)]. For a given u the best v is an
///         eigenvector of a 3 x 3 matrix, so the sum's root g(u) is a function on the sphere; it is Lipschitz with
///         constant sqrt(N) in u, for each |R_i v| = 1. Branch and bound over the faces of a cube covers the half
///         sphere.
/// Exact   no: the least g is found to within kSearchGap * sqrt(N), then polished by turns.
/// Cost    some thousand eigenvectors, whatever N, after one pass.
#pragma once

#include <span>

#include "robot/joint/transform.h"

namespace tact::joint {

inline constexpr double kSearchGap = 1e-3;  // radian, root mean square

/// Sum of vec(R) vec(R)^T over orientations, all that the search needs of them.
class OrientationMoment {
 public:
  void Add(const Eigen::Matrix3d& R) {
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> r(R.data());
    sum_.noalias() += r * r.transpose();
    count_ += 1;
  }
  Eigen::Matrix<double, 9, 9> Mean() const { return sum_ / count_; }

 private:
  Eigen::Matrix<double, 9, 9> sum_ = Eigen::Matrix<double, 9, 9>::Zero();  // R by columns
  double count_ = 0;
};

struct TwoAxes {
  Eigen::Vector3d u_B, v_A;
  double rms = 0;  // of u . R_i v
  int evaluations = 0;
};

/// Pre: at least one orientation.
TwoAxes FindTwoAxes(const OrientationMoment& orientations);
TwoAxes FindTwoAxes(std::span<const Transform> poses);

/// The local least sum that turns between u and v lead to, from one u.
TwoAxes PolishTwoAxes(const OrientationMoment& orientations, const Eigen::Vector3d& u_B);

}  // namespace tact::joint

/// @file
/// Decompositions of small symmetric and square matrices, compiled once.
#pragma once

#include <Eigen/Core>

namespace tact::joint {

struct SymmetricEigen3 {
  Eigen::Vector3d values;   // ascending
  Eigen::Matrix3d vectors;  // columns
};
SymmetricEigen3 EigenOf(const Eigen::Matrix3d& symmetric);

struct Svd3 {
  Eigen::Matrix3d U;
  Eigen::Vector3d values;  // descending
  Eigen::Matrix3d V;
};
Svd3 SvdOf(const Eigen::Matrix3d& matrix);

/// The rotation R that makes the sum of |R_i - R|^2 least, of the sum of rotations R_i: also the least sum of 1 - cos
/// of the angles between [thesis, eq. (4.6)], and no other is as good unless the sum is of lower rank.
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& sum);

using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 14, 1>;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 14, 14>;

/// The shortest x with symmetric x = right in the least squares; directions whose eigenvalue is below tolerance times
/// the largest are left alone.
SmallVector SolveSymmetric(const SmallMatrix& symmetric, const SmallVector& right, double tolerance = 1e-9);

/// The pseudo-inverse of a positive semidefinite matrix; directions as in SolveSymmetric. rank: how many it inverted.
SmallMatrix PseudoInverse(const SmallMatrix& symmetric, double tolerance = 1e-12, int* rank = nullptr);

/// The symmetric square root of a positive semidefinite matrix.
SmallMatrix SquareRoot(const SmallMatrix& symmetric);

/// Any right-handed frame with z along the unit vector.
Eigen::Matrix3d FrameWithZ(const Eigen::Vector3d& z);

}  // namespace tact::joint

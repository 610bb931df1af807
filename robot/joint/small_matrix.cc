#include "robot/joint/small_matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

namespace tact::joint {

SymmetricEigen3 EigenOf(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Svd3 SvdOf(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& sum) {
  Svd3 svd = SvdOf(sum);
  if (svd.U.determinant() * svd.V.determinant() < 0) svd.U.col(2) *= -1;
  return svd.U * svd.V.transpose();
}

SmallMatrix PseudoInverse(const SmallMatrix& symmetric, double tolerance, int* rank) {
  // Unknowns may have different units: each is measured in what makes its diagonal one.
  SmallVector unit = symmetric.diagonal();
  for (double& value : unit) value = value > 0 ? 1 / std::sqrt(value) : 0;
  const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(
      SmallMatrix(unit.asDiagonal() * symmetric * unit.asDiagonal()));
  SmallVector inverse = solver.eigenvalues();
  const double least = tolerance * inverse.cwiseAbs().maxCoeff();
  int count = 0;
  for (double& value : inverse) {
    const bool kept = value > least;
    value = kept ? 1 / value : 0;
    count += kept;
  }
  if (rank) *rank = count;
  const SmallMatrix vectors = unit.asDiagonal() * solver.eigenvectors();
  return vectors * inverse.asDiagonal() * vectors.transpose();
}

SmallVector SolveSymmetric(const SmallMatrix& symmetric, const SmallVector& right, double tolerance) {
  return PseudoInverse(symmetric, tolerance) * right;
}

SmallMatrix SquareRoot(const SmallMatrix& symmetric) {
  const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(symmetric);
  const SmallVector roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return solver.eigenvectors() * roots.asDiagonal() * solver.eigenvectors().transpose();
}

Eigen::Matrix3d FrameWithZ(const Eigen::Vector3d& z) {
  Eigen::Vector3d least = Eigen::Vector3d::Unit([&] {
    Eigen::Index i = 0;
    z.cwiseAbs().minCoeff(&i);
    return i;
  }());
  Eigen::Matrix3d frame;
  frame.col(2) = z;
  frame.col(0) = least.cross(z).normalized();
  frame.col(1) = z.cross(frame.col(0));
  return frame;
}

}  // namespace tact::joint

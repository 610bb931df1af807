#include "robot/planning/motion_rows.h"

#include <algorithm>

#include "robot/joint/small_matrix.h"

namespace tact::planning {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The eigenvectors of a Gram matrix whose eigenvalues are zero, or the 3 - rank least ones.
Basis NullSpace(const Matrix3d& gram, double scale, std::optional<int> rank) {
  const joint::SymmetricEigen3 eigen = joint::EigenOf(gram);
  const double least = kRankTolerance * kRankTolerance * scale;
  int zeros = 0;
  while (zeros < 3 && eigen.values[zeros] <= least) ++zeros;
  Basis basis;
  for (int i = 0; i < (rank ? 3 - *rank : zeros); ++i) basis.emplace_back(eigen.vectors.col(i));
  return basis;
}

// The pseudo-inverse of F^T F on the complement of its null space.
Matrix3d InverseOutside(const Matrix3d& gram, const Basis& null_space) {
  Matrix3d filled = gram, projection = Matrix3d::Identity();
  for (const Vector3d& v : null_space) {
    filled += v * v.transpose();
    projection -= v * v.transpose();
  }
  return projection * filled.inverse() * projection;
}

}  // namespace

MotionRows MotionRowsOf(const Relation& relation, const recognition::SolidF& moving,
                        const recognition::SolidF& fixed, const joint::Transform& X_FM, double size,
                        const std::optional<Ranks>& ranks) {
  Vector3d centre = Vector3d::Zero();
  std::vector<recognition::Gap> gaps;
  for (const auto& contact : relation) {
    gaps.push_back(GapOf(contact, moving, fixed, X_FM));
    centre += gaps.back().at / static_cast<double>(relation.size());
  }
  Matrix3d turns = Matrix3d::Zero(), mixed = Matrix3d::Zero(), shifts = Matrix3d::Zero();
  for (const auto& gap : gaps) {
    const Vector3d n = gap.row.tail<3>(), moment = (gap.row.head<3>().transpose() - centre.cross(n)) / size;
    turns += moment * moment.transpose();
    mixed += moment * n.transpose();
    shifts += n * n.transpose();
  }
  const double scale = std::max<double>(1, static_cast<double>(relation.size()));
  MotionRows rows;
  rows.translations = NullSpace(shifts, scale, ranks ? std::optional(ranks->translation) : std::nullopt);
  const Matrix3d left = turns - mixed * InverseOutside(shifts, rows.translations) * mixed.transpose();
  rows.axes = NullSpace(left, scale, ranks ? std::optional(ranks->rotation) : std::nullopt);
  rows.ranks = {3 - static_cast<int>(rows.translations.size()), 3 - static_cast<int>(rows.axes.size())};
  return rows;
}

Vector3d PartOutside(const Basis& basis, const Vector3d& v) {
  Vector3d rest = v;
  for (const Vector3d& b : basis) rest -= b.dot(v) * b;
  return rest;
}

double SizeOf(const recognition::SolidF& solid) {
  if (solid.vertices.empty()) return 0;
  Vector3d low = solid.vertices[0], high = low;
  for (const Vector3d& v : solid.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

}  // namespace tact::planning

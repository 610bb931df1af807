#include "robot/recognition/contact_projection.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace tact::recognition {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using joint::Transform;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kMostSteps = 25;  // Gauss-Newton takes 4 to 6 where it converges
/// Rows, whose length is about one, that depend on the others to this are taken as dependent: parallel walls seen askew by
/// noise are, and would ask for a long way.
constexpr double kDependent = 1e-3;

// A gap's rate along ways as Between gives them; turn_of_way in F.
Eigen::Matrix<double, 1, 6> RowOfWay(const Gap& gap, const Vector3d& centre, const Matrix3d& turn_of_way) {
  const Vector3d n = gap.row.tail<3>().transpose();
  Eigen::Matrix<double, 1, 6> row;
  row << (gap.at - centre).cross(n).transpose() * turn_of_way, n.transpose();
  return row;
}

// What takes a pose away from another, both halves with the length of the way they make.
Vector6 Between(const PoseMetric& metric, const Transform& from, const Transform& to) {
  Vector6 way;
  way.head<3>() =
      to.R * metric.way_of_turn() * to.R.transpose() * joint::RotationLog(to.R * from.R.transpose());
  way.tail<3>() = to * metric.centroid() - from * metric.centroid();
  return way;
}

Transform Moved(const PoseMetric& metric, const Transform& X, const Vector6& way) {
  const Vector3d centre = X * metric.centroid() + way.tail<3>();
  Transform moved;
  moved.R = joint::RotationExp(X.R * metric.turn_of_way() * X.R.transpose() * way.head<3>()) * X.R;
  moved.p = centre - moved.R * metric.centroid();
  return moved;
}

}  // namespace

PoseMetric::PoseMetric(const SolidF& moving) {
  centroid_ = Vector3d::Zero();
  for (const Vector3d& p : moving.vertices) centroid_ += p;
  const auto count = static_cast<double>(moving.vertices.size());
  centroid_ /= count;
  Matrix3d inertia = Matrix3d::Zero();
  for (const Vector3d& p : moving.vertices) {
    const Vector3d r = p - centroid_;
    inertia += (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose()) / count;
    radius_ += r.squaredNorm() / count;
  }
  radius_ = std::sqrt(radius_);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(inertia);
  way_of_turn_ = eigen.operatorSqrt();
  turn_of_way_ = eigen.operatorInverseSqrt();
}

double PoseMetric::Distance(const Transform& a, const Transform& b) const {
  return Between(*this, a, b).norm();
}

std::optional<Projection> ProjectOntoContacts(const std::vector<PointContact>& contacts, const SolidF& moving,
                                              const SolidF& fixed, const PoseMetric& metric,
                                              const Transform& start, const Transform& guess, double farthest,
                                              double exact) {
  Projection projection{guess, 0, 0};
  const auto count = static_cast<Eigen::Index>(contacts.size());
  Eigen::Matrix<double, Eigen::Dynamic, 6> rows(count, 6);
  Eigen::VectorXd gaps(count);
  for (int step = 0; step < kMostSteps; ++step) {
    Transform& X = projection.X_FM;
    const Vector3d centre = X * metric.centroid();
    const Matrix3d turn_of_way = X.R * metric.turn_of_way() * X.R.transpose();
    for (Eigen::Index i = 0; i < count; ++i) {
      const Gap gap = GapOf(contacts[static_cast<size_t>(i)], moving, fixed, X);
      gaps[i] = gap.gap;
      rows.row(i) = RowOfWay(gap, centre, turn_of_way);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(kDependent);
    solver.compute(rows);
    projection.restricted = static_cast<int>(solver.rank());
    const Vector6 way = Between(metric, start, X);
    const Vector6 next = solver.solve(rows * way - gaps);
    const Vector6 change = next - way;
    if (gaps.cwiseAbs().maxCoeff() < exact && change.norm() < exact) {
      projection.displacement = way.norm();
      return projection;
    }
    if (!(next.norm() < farthest)) return std::nullopt;
    X = Moved(metric, X, change);
  }
  return std::nullopt;
}

std::vector<PointContact> IndependentContacts(const std::vector<PointContact>& contacts, const SolidF& moving,
                                              const SolidF& fixed, const PoseMetric& metric,
                                              const Transform& X_FM) {
  const Vector3d centre = X_FM * metric.centroid();
  const Matrix3d turn_of_way = X_FM.R * metric.turn_of_way() * X_FM.R.transpose();
  std::vector<PointContact> independent;
  Eigen::Matrix<double, 6, 6> basis;  // orthonormal rows, one an independent contact
  Eigen::Index rank = 0;
  for (const PointContact& contact : contacts) {
    if (rank == 6) break;
    Eigen::Matrix<double, 1, 6> row = RowOfWay(GapOf(contact, moving, fixed, X_FM), centre, turn_of_way);
    // Twice is enough [Kahan, Parlett].
    for (int twice = 0; twice < 2; ++twice) {
      for (Eigen::Index k = 0; k < rank; ++k) row -= row.dot(basis.row(k)) * basis.row(k);
    }
    if (row.norm() < kDependent) continue;
    basis.row(rank++) = row.normalized();
    independent.push_back(contact);
  }
  return independent;
}

}  // namespace tact::recognition

#include "robot/correction/nearest_pose.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "robot/correction/linear_correction.h"
#include "robot/correction/realisation.h"
#include "robot/correction/small_qp.h"

namespace tact::correction {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using joint::Transform;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kIterations = 60;
constexpr double kIndependent = 1e-4;  // of a row's length: what must be left of it across the rows before it
constexpr double kReturned = 1e-11;    // times the models' size: a gap that counts as none on the manifold
constexpr double kStill = 1e-7;        // times the models' size: a step that counts as none
constexpr double kLess = 1e-10;        // of the merit: a decrease that counts as one
constexpr double kReach =
    0.25;  // times the models' size: inequalities farther from binding are left out of a step
constexpr double kLongest = 0.2;         // a step at most, in radians and in the models' size
constexpr double kLeastCurvature = 0.1;  // of the Lagrangian, the distance's own being 1
constexpr double kLoose =
    1e-8;  // times the models' size: a violation that a step need not mend; kTouching is far above
constexpr double kPenalty = 100;  // of a violation, in distance: above what multipliers sum to

double Cotangent(double half) { return half < 1e-4 ? 1 - half * half / 3 : half / std::tan(half); }

// Rows and values of features at a pose.
struct Rows {
  MatrixXd rows;
  VectorXd values;
  std::vector<Matrix6> hessians;
};

Rows RowsOf(const std::vector<Feature>& features, const Posed<Jet<6>>& X, bool hessians) {
  Rows all{
      MatrixXd(static_cast<Index>(features.size()), 6), VectorXd(static_cast<Index>(features.size())), {}};
  for (size_t i = 0; i < features.size(); ++i) {
    const Jet<6> jet = ValueOf(features[i], X);
    all.rows.row(static_cast<Index>(i)) = jet.gradient;
    all.values[static_cast<Index>(i)] = jet.value;
    if (hessians) all.hessians.push_back(jet.hessian);
  }
  return all;
}

bool Same(const Feature& a, const Feature& b) {
  return a.kind == b.kind && a.moving_point == b.moving_point && a.fixed_point == b.fixed_point &&
         a.moving_direction == b.moving_direction && a.fixed_direction == b.fixed_direction;
}

// Multipliers of the features that were there before; of the others none.
VectorXd Carried(const VectorXd& multipliers, const std::vector<Feature>& before,
                 const std::vector<Feature>& now) {
  VectorXd carried = VectorXd::Zero(static_cast<Index>(now.size()));
  for (size_t i = 0; i < before.size(); ++i) {
    if (multipliers[static_cast<Index>(i)] == 0) continue;
    for (size_t k = 0; k < now.size(); ++k)
      if (Same(before[i], now[k])) carried[static_cast<Index>(k)] = multipliers[static_cast<Index>(i)];
  }
  return carried;
}

}  // namespace

double Metric::LengthFor(const Models& models) const {
  if (rotation_first) return kFirst * models.size;
  return length > 0 ? length : models.size;
}

Displacement DisplacementBetween(const Transform& X0, const Transform& X, const Vector3d& reference) {
  return {joint::RotationLog(X.R * X0.R.transpose()).norm(), (X * reference - X0 * reference).norm()};
}

// The inequalities near a pose, and by how much the worst is violated.
struct NearestPose::Point {
  std::vector<Feature> inequalities;
  double violation = 0, merit = 0;
};

NearestPose::NearestPose(const Models& models, const Relation& relation, const Metric& metric)
    : models_(models), relation_(relation), metric_(metric), length_(metric.LengthFor(models)) {
  if (!relation_.realisation) return;
  std::vector<Feature> all;
  for (const auto& contact : relation_.contacts) all.push_back(GapFeature(contact, models));
  MatrixXd rows = RowsOf(all, JetAt(*relation_.realisation, metric_.reference), false).rows;
  rows.leftCols<3>() /= models.size;
  for (Index i = 0; i < rows.rows(); ++i) rows.row(i) /= std::max(rows.row(i).norm(), kIndependent);
  // Those with the simplest equations first: they come in the order of their kinds.
  for (size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].kind == all[begin].kind) ++end;
    for (;;) {
      Index best = 0;
      const auto part = rows.middleRows(static_cast<Index>(begin), static_cast<Index>(end - begin));
      if (part.rowwise().norm().maxCoeff(&best) < kIndependent) break;
      best += static_cast<Index>(begin);
      equalities_.push_back(all[static_cast<size_t>(best)]);
      const Vector6 q = rows.row(best).normalized();
      const VectorXd shares = rows * q;
      rows -= shares * q.transpose();
    }
  }
}

// Newton's method by steps of least norm.
bool NearestPose::Return(Transform& X, const std::vector<Feature>& on) const {
  if (on.empty()) return true;
  for (int i = 0; i < 12; ++i) {
    Rows here = RowsOf(on, JetAt(X, metric_.reference), false);
    const double worst = here.values.cwiseAbs().maxCoeff();
    if (worst <= kReturned * models_.size) return true;
    if (!std::isfinite(worst)) return false;
    here.rows.leftCols<3>() /= models_.size;
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(here.rows);
    decomposition.setThreshold(kIndependent);
    Vector6 step = decomposition.solve(-here.values);
    step.head<3>() /= models_.size;
    const double turn = step.head<3>().norm();
    if (turn > 1) step /= turn;
    X = Stepped(X, metric_.reference, step);
  }
  return false;
}

NearestPose::Point NearestPose::At(const Transform& X0, const Transform& X) const {
  Point point;
  const double near = kReach * models_.size;
  const Posed<double> posed = PosedAt(X, metric_.reference);
  const auto add = [&](const Feature& feature) {
    const double value = ValueOf(feature, posed);
    if (value < near) point.inequalities.push_back(feature);
    point.violation = std::max(point.violation, -value);
  };
  for (const auto& contact : relation_.contacts)
    for (const Feature& feature : WithinFeatures(contact, models_, X)) add(feature);
  for (const ConvexPiece& a : models_.moving.pieces) {
    for (const ConvexPiece& b : models_.fixed.pieces) {
      if (BallGap(a, b, X) > near) continue;
      const Separation widest = Widest(a, b, X);
      if (widest.gap > near) continue;
      point.violation = std::max(point.violation, -widest.gap);
      for (const Feature& feature : SeparationFeatures(a, b, X, widest, near)) add(feature);
    }
  }
  const double distance = DisplacementBetween(X0, X, metric_.reference).Distance(length_);
  const double scale = std::max(1.0, length_ / models_.size);
  point.violation = std::max(0.0, point.violation - kLoose * models_.size);
  point.merit = distance * distance / 2 + kPenalty * models_.size * scale * point.violation;
  return point;
}

bool NearestPose::LocalOptimum(const Transform& X0, Transform& X, int& iterations) const {
  if (!Return(X, equalities_)) return false;
  VectorXd on_equalities = VectorXd::Zero(static_cast<Index>(equalities_.size()));
  Point here = At(X0, X);
  const double size = models_.size;
  Vector6 scale;
  scale << Vector3d::Constant(1 / length_), Vector3d::Ones();
  VectorXd pressed;
  std::vector<Feature> before;  // what they press
  for (int i = 0; i < kIterations; ++i, ++iterations) {
    const Posed<Jet<6>> jet = JetAt(X, metric_.reference);
    const Rows equal = RowsOf(equalities_, jet, true), above = RowsOf(here.inequalities, jet, true);
    const Vector3d turn = joint::RotationLog(X.R * X0.R.transpose());
    const double angle = turn.norm();
    Vector6 g;
    g << length_ * length_ * turn, X * metric_.reference - X0 * metric_.reference;
    // Of |log|^2 / 2: 1 along the turn's axis, (angle / 2) cot(angle / 2) across.
    const double across = std::max(kLeastCurvature, Cotangent(angle / 2));
    Matrix6 B = Matrix6::Identity();
    B.topLeftCorner<3, 3>() *= across * length_ * length_;
    if (angle > 0)
      B.topLeftCorner<3, 3>() += (1 - across) * length_ * length_ / (angle * angle) * turn * turn.transpose();
    const auto solve = [&](const Matrix6& hessian) {
      SmallQp qp;
      qp.B = hessian;
      qp.g = scale.cwiseProduct(g);
      qp.E = equal.rows * scale.asDiagonal();
      qp.e = -equal.values;
      qp.C = above.rows * scale.asDiagonal();
      qp.c = -above.values;
      qp.weight = kPenalty * size * std::max(1.0, length_ / size);
      return Solve(qp, kLoose * size);
    };
    const Matrix6 first = scale.asDiagonal() * B * scale.asDiagonal();
    if (i == 0) {
      // The first multipliers, with the distance's own curvature.
      const SmallQpAnswer guess = solve(first);
      pressed = guess.inequalities, on_equalities = guess.equalities;
    } else {
      pressed = Carried(pressed, before, here.inequalities);
    }
    for (size_t k = 0; k < equalities_.size(); ++k)
      B -= on_equalities[static_cast<Index>(k)] * equal.hessians[k];
    for (size_t k = 0; k < here.inequalities.size(); ++k)
      if (pressed[static_cast<Index>(k)] > 0) B -= pressed[static_cast<Index>(k)] * above.hessians[k];
    const Matrix6 lagrangian = scale.asDiagonal() * B * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(lagrangian);
    const Vector6 curvatures = eigen.eigenvalues().cwiseMax(kLeastCurvature);
    const SmallQpAnswer qp =
        solve(eigen.eigenvectors() * curvatures.asDiagonal() * eigen.eigenvectors().transpose());
    on_equalities = qp.equalities, pressed = qp.inequalities;
    before = here.inequalities;
    Vector6 step = scale.cwiseProduct(qp.x);
    const double length = std::max(step.head<3>().norm(), step.tail<3>().norm() / size);
    if (length < kStill) return true;
    if (length > kLongest) step *= kLongest / length;
    std::vector<Feature> on = equalities_;
    for (size_t k = 0; k < here.inequalities.size(); ++k)
      if (pressed[static_cast<Index>(k)] > 0) on.push_back(here.inequalities[k]);
    bool moved = false;
    for (double part = 1; part > 1e-3 && !moved; part /= 2) {
      for (const bool with_active : {true, false}) {
        if (with_active && (part < 1 || on.size() == equalities_.size())) continue;
        Transform next = Stepped(X, metric_.reference, part * step);
        if (!Return(next, with_active ? on : equalities_)) continue;
        Point there = At(X0, next);
        if (!(there.merit < here.merit * (1 - kLess))) continue;
        X = next, here = std::move(there), moved = true;
        break;
      }
    }
    if (!moved) return true;
  }
  return true;
}

NearestPoseAnswer NearestPose::Find(const Transform& X0) const {
  if (!relation_.realisation) {
    Relation found = relation_;
    found.realisation = FindRealisation(models_, relation_.contacts, X0);
    if (!found.realisation) return {X0, Outcome::kNoRealisation, 0, 0};
    return NearestPose(models_, found, metric_).Find(X0);
  }
  NearestPoseAnswer best{X0, Outcome::kNotConverged, HUGE_VAL, 0};
  const auto consider = [&](const Transform& X) {
    const double distance = DisplacementBetween(X0, X, metric_.reference).Distance(length_);
    if (distance >= best.distance) return;
    const Outcome outcome = Judge(models_, relation_.contacts, X);
    if (outcome == Outcome::kCorrected) best.X_FM = X, best.outcome = outcome, best.distance = distance;
  };
  const auto start = [&](Transform X) {
    if (LocalOptimum(X0, X, best.iterations)) consider(X);
  };
  start(X0);
  start({LinearOrientation(models_, relation_, X0), X0.p});
  if (best.outcome != Outcome::kCorrected) {
    start(*relation_.realisation);
    consider(*relation_.realisation);
  }
  if (best.outcome != Outcome::kCorrected) best.distance = 0;
  return best;
}

}  // namespace tact::correction

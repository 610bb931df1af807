#include "robot/correction/small_qp.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <vector>

#include "algebra/error.h"

namespace tact::correction {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNone = 1e-12;  // a normal this short, over its length, lies in the span of the active ones
constexpr double kSlackCurvature =
    1;  // makes the slack's part of the sum strictly convex; any positive number will do

// min y . G y / 2 + h . y with N y >= b by the dual method: from the unconstrained minimum, one violated row at a time.
class DualActiveSet {
 public:
  DualActiveSet(const MatrixXd& G, const VectorXd& h, MatrixXd N, VectorXd b, double tolerance)
      : N_(std::move(N)), b_(std::move(b)), tolerance_(tolerance), factor_(G) {
    if (factor_.info() != Eigen::Success) throw InvariantError("small quadratic programme: not convex");
    y = -factor_.solve(h);
  }
  // The last row first: the slack's own sign. Else a row that the equalities imply could stand for it.
  bool Run() {
    if (N_.row(N_.rows() - 1).dot(y) < b_[N_.rows() - 1] && !Add(N_.rows() - 1)) return false;
    const Index limit = 20 * (N_.rows() + N_.cols());
    for (Index i = 0; i < limit; ++i) {
      Index worst = -1;
      if ((N_ * y - b_).minCoeff(&worst) >= -tolerance_) return true;
      if (!Add(worst)) return false;
    }
    return false;
  }
  VectorXd Multipliers() const {
    VectorXd all = VectorXd::Zero(N_.rows());
    for (size_t i = 0; i < active_.size(); ++i) all[active_[i]] = u_[i];
    return all;
  }
  VectorXd y;

 private:
  bool Add(Index row) {
    const VectorXd n = N_.row(row);
    double pressed = 0;
    for (size_t round = 0; round <= active_.size() + 1 || round < 100; ++round) {
      const auto count = static_cast<Index>(active_.size());
      MatrixXd A(N_.cols(), count);
      for (Index i = 0; i < count; ++i) A.col(i) = N_.row(active_[static_cast<size_t>(i)]);
      const MatrixXd solved = factor_.solve(A);
      VectorXd r = VectorXd::Zero(count);
      if (count > 0) r = (A.transpose() * solved).ldlt().solve(solved.transpose() * n);
      const VectorXd z = factor_.solve(n) - solved * r;
      double most = HUGE_VAL;
      Index leaving = -1;
      for (Index i = 0; i < count; ++i) {
        if (r[i] > kNone && u_[static_cast<size_t>(i)] / r[i] < most) {
          most = u_[static_cast<size_t>(i)] / r[i];
          leaving = i;
        }
      }
      const double slope = z.dot(n);
      const double full = slope > kNone * n.dot(factor_.solve(n)) ? (b_[row] - n.dot(y)) / slope : HUGE_VAL;
      const double step = std::min(most, full);
      if (step == HUGE_VAL) return false;
      if (full < HUGE_VAL) y += step * z;
      for (Index i = 0; i < count; ++i) u_[static_cast<size_t>(i)] -= step * r[i];
      pressed += step;
      if (step == full) {
        active_.push_back(row);
        u_.push_back(pressed);
        return true;
      }
      active_.erase(active_.begin() + leaving);
      u_.erase(u_.begin() + leaving);
    }
    return false;
  }

  MatrixXd N_;
  VectorXd b_;
  double tolerance_;
  Eigen::LLT<MatrixXd> factor_;
  std::vector<Index> active_;
  std::vector<double> u_;
};

}  // namespace

SmallQpAnswer Solve(const SmallQp& qp, double tolerance) {
  const Index n = qp.g.size(), m = qp.E.rows(), k = qp.C.rows(), free = n - m;
  MatrixXd Z = MatrixXd::Identity(n, n);
  VectorXd particular = VectorXd::Zero(n);
  if (m > 0) {
    const Eigen::HouseholderQR<MatrixXd> qr(qp.E.transpose());
    const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(n, n);
    const MatrixXd R = qr.matrixQR().topRows(m).triangularView<Eigen::Upper>();
    particular = Q.leftCols(m) * R.transpose().triangularView<Eigen::Lower>().solve(qp.e);
    Z = Q.rightCols(free);
  }
  MatrixXd G = MatrixXd::Zero(free + 1, free + 1), N = MatrixXd::Zero(k + 1, free + 1);
  VectorXd h(free + 1), b = VectorXd::Zero(k + 1);
  G.topLeftCorner(free, free) = Z.transpose() * qp.B * Z;
  G(free, free) = kSlackCurvature;
  h.head(free) = Z.transpose() * (qp.g + qp.B * particular);
  h[free] = qp.weight;
  if (k > 0) {
    N.topLeftCorner(k, free) = qp.C * Z;
    b.head(k) = qp.c - qp.C * particular;
  }
  N.col(free).setOnes();
  DualActiveSet method(G, h, std::move(N), std::move(b), tolerance);
  SmallQpAnswer answer;
  answer.ended = method.Run();
  answer.x = particular + Z * method.y.head(free);
  answer.violation = std::max(0.0, method.y[free]);
  answer.inequalities = method.Multipliers().head(k);
  answer.equalities = VectorXd::Zero(m);
  if (m > 0) {
    VectorXd left = qp.B * answer.x + qp.g;
    if (k > 0) left -= qp.C.transpose() * answer.inequalities;
    answer.equalities = qp.E.transpose().householderQr().solve(left);
  }
  return answer;
}

}  // namespace tact::correction

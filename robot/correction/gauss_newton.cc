#include "robot/correction/gauss_newton.h"

#include <Eigen/SVD>
#include <cmath>

namespace tact::correction {
namespace {

using Eigen::Vector3d;
using joint::Transform;

constexpr double kFarAway = 1e3;  // times the models' size: no sensible pose

}  // namespace

GaussNewtonAnswer CorrectByGaussNewton(const Models& models,
                                       const std::vector<recognition::PointContact>& contacts,
                                       const Transform& X_FM, const GaussNewtonOptions& options) {
  GaussNewtonAnswer answer{X_FM, Outcome::kNotConverged, 0};
  const auto count = static_cast<Eigen::Index>(contacts.size());
  Eigen::MatrixXd rows(count, 6);
  Eigen::VectorXd gaps(count);
  const double enough = options.enough * models.size;
  for (;; ++answer.iterations) {
    Transform& X = answer.X_FM;
    const Vector3d centre = options.about_object ? X.p : Vector3d::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
      const recognition::Gap gap =
          GapOf(contacts[static_cast<size_t>(i)], models.moving.elements, models.fixed.elements, X);
      gaps[i] = gap.gap;
      const Vector3d n = gap.row.tail<3>();
      rows.row(i) << (gap.at - centre).cross(n).transpose() / options.radian, n.transpose();
    }
    if (count == 0 || gaps.cwiseAbs().maxCoeff() <= enough) break;
    if (!gaps.allFinite() || X.p.norm() > kFarAway * models.size) {
      answer.outcome = Outcome::kDiverged;
      return answer;
    }
    if (answer.iterations == options.iterations) return answer;
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(options.cutoff);
    const Eigen::Matrix<double, 6, 1> step = svd.solve(-gaps);
    // A location's step is the object's own; about the fixed origin the turn carries the location along.
    const Eigen::Matrix3d turn = joint::RotationExp(step.head<3>() / options.radian);
    X.R = Eigen::Quaterniond(turn * X.R).normalized().toRotationMatrix();
    X.p = (options.about_object ? X.p : Vector3d(turn * X.p)) + step.tail<3>();
  }
  answer.outcome = Judge(models, contacts, answer.X_FM);
  return answer;
}

}  // namespace tact::correction

#include "robot/correction/contact_functions.h"

namespace tact::correction {

template Jet<6> ValueOf(const Feature& f, const Posed<Jet<6>>& X);

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// exp(w) u = u + w x u + (w (w . u) - u (w . w)) / 2, up to order 2.
Triple<Jet<6>> Turned(const Vector3d& u) {
  Triple<Jet<6>> turned;
  Jet<6>* const parts[] = {&turned.x, &turned.y, &turned.z};
  const Matrix3d rates = (Matrix3d() << 0, u.z(), -u.y(), -u.z(), 0, u.x(), u.y(), -u.x(), 0).finished();
  for (int i = 0; i < 3; ++i) {
    parts[i]->value = u[i];
    parts[i]->gradient.head<3>() = rates.row(i);
    Matrix3d h = -u[i] * Matrix3d::Identity();
    h.row(i) += u.transpose() / 2;
    h.col(i) += u / 2;
    parts[i]->hessian.topLeftCorner<3, 3>() = h;
  }
  return turned;
}

}  // namespace

Posed<double> PosedAt(const joint::Transform& X_FM, const Vector3d& reference) {
  Posed<double> posed;
  for (int i = 0; i < 3; ++i)
    posed.columns[static_cast<size_t>(i)] = {X_FM.R(0, i), X_FM.R(1, i), X_FM.R(2, i)};
  const Vector3d at = X_FM * reference;
  posed.at = {at.x(), at.y(), at.z()};
  posed.reference = reference;
  return posed;
}

Posed<Jet<6>> JetAt(const joint::Transform& X_FM, const Vector3d& reference) {
  Posed<Jet<6>> posed;
  for (int i = 0; i < 3; ++i) posed.columns[static_cast<size_t>(i)] = Turned(X_FM.R.col(i));
  const Vector3d at = X_FM * reference;
  posed.at = {Jet<6>::Variable(at.x(), 3), Jet<6>::Variable(at.y(), 4), Jet<6>::Variable(at.z(), 5)};
  posed.reference = reference;
  return posed;
}

joint::Transform Stepped(const joint::Transform& X_FM, const Vector3d& reference,
                         const Eigen::Matrix<double, 6, 1>& step) {
  const Vector3d at = X_FM * reference + step.tail<3>();
  const Matrix3d R =
      Eigen::Quaterniond(joint::RotationExp(step.head<3>()) * X_FM.R).normalized().toRotationMatrix();
  return {R, at - R * reference};
}

}  // namespace tact::correction

/// @file
/// Values with exact first and second derivatives in the seven numbers of a knot: quaternion w, x, y, z and location.
/// Model   Forward mode: products by Leibniz' rule. R(q) is the quadratic form that is a rotation where |q| = 1.
/// Units   lengths over the moving solid's size, so that all seven are of one scale.
#pragma once

#include <array>

#include "robot/recognition/point_contact.h"

namespace tact::planning {

struct Jet {
  using Gradient = Eigen::Matrix<double, 7, 1>;
  using Hessian = Eigen::Matrix<double, 7, 7>;

  double value = 0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  Jet(double v = 0) : value(v) {}  // NOLINT: numbers are constant jets
  static Jet Variable(int index, double v);
};

Jet operator+(const Jet& a, const Jet& b);
Jet operator-(const Jet& a, const Jet& b);
Jet operator*(const Jet& a, const Jet& b);

using JetVector = std::array<Jet, 3>;

/// A pose whose seven numbers are the variables.
struct KnotJets {
  explicit KnotJets(const double* numbers);
  JetVector Rotated(const Eigen::Vector3d& v) const;

  std::array<Jet, 4> q;
  JetVector t;
};

/// A point contact's gap over the size. Of edges it is times the sine of their angle: zero in the same places, of the same
/// sign, and a polynomial.
Jet GapJet(const recognition::PointContact& contact, const recognition::SolidF& moving,
           const recognition::SolidF& fixed, double size, const KnotJets& knot);

}  // namespace tact::planning

/// @file
/// Values with their exact first and second derivatives, forward mode [Griewank and Walther 2008].
/// Model   f(x + d) = value + gradient . d + d . hessian d / 2, up to order 2.
/// Shapes  N variables, fixed.
/// Cost    O(N^2) an operation; nothing is allocated.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace tact::correction {

template <int N>
struct Jet {
  using Gradient = Eigen::Matrix<double, N, 1>;
  using Hessian = Eigen::Matrix<double, N, N>;
  double value = 0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  Jet() = default;
  Jet(double constant) : value(constant) {}  // NOLINT: constants mix with jets
  static Jet Variable(double value, int index) {
    Jet jet(value);
    jet.gradient[index] = 1;
    return jet;
  }
};

// Plain loops: unrolled expressions of all these entries would take minutes to compile.
template <int N>
Jet<N> operator+(Jet<N> a, const Jet<N>& b) {
  a.value += b.value;
  for (int i = 0; i < N; ++i) a.gradient.data()[i] += b.gradient.data()[i];
  for (int i = 0; i < N * N; ++i) a.hessian.data()[i] += b.hessian.data()[i];
  return a;
}
template <int N>
Jet<N> operator*(Jet<N> a, double b) {
  a.value *= b;
  for (int i = 0; i < N; ++i) a.gradient.data()[i] *= b;
  for (int i = 0; i < N * N; ++i) a.hessian.data()[i] *= b;
  return a;
}
template <int N>
Jet<N> operator-(const Jet<N>& a, const Jet<N>& b) {
  return a + b * -1.0;
}
template <int N>
Jet<N> operator+(Jet<N> a, double b) {
  a.value += b;
  return a;
}
template <int N>
Jet<N> operator-(Jet<N> a, double b) {
  a.value -= b;
  return a;
}
template <int N>
Jet<N> operator*(const Jet<N>& a, const Jet<N>& b) {
  Jet<N> c;
  const double *x = a.gradient.data(), *y = b.gradient.data();
  c.value = a.value * b.value;
  for (int i = 0; i < N; ++i) c.gradient.data()[i] = x[i] * b.value + a.value * y[i];
  for (int j = 0; j < N; ++j) {
    for (int i = 0; i < N; ++i) {
      const int k = j * N + i;
      c.hessian.data()[k] =
          a.hessian.data()[k] * b.value + a.value * b.hessian.data()[k] + x[i] * y[j] + x[j] * y[i];
    }
  }
  return c;
}

/// f(a), from f and its two derivatives there.
template <int N>
Jet<N> Chain(const Jet<N>& a, double f, double slope, double curvature) {
  Jet<N> c;
  c.value = f;
  c.gradient = slope * a.gradient;
  c.hessian = slope * a.hessian + curvature * a.gradient * a.gradient.transpose();
  return c;
}

/// Three numbers of one kind.
template <class S>
struct Triple {
  S x, y, z;
};
template <class S>
Triple<S> operator+(const Triple<S>& a, const Triple<S>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S>
Triple<S> operator-(const Triple<S>& a, const Eigen::Vector3d& b) {
  return {a.x - b.x(), a.y - b.y(), a.z - b.z()};
}
template <class S>
S Dot(const Triple<S>& a, const Triple<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
S Dot(const Triple<S>& a, const Eigen::Vector3d& b) {
  return a.x * b.x() + a.y * b.y() + a.z * b.z();
}
template <class S>
Triple<S> Cross(const Triple<S>& a, const Eigen::Vector3d& b) {
  return {a.y * b.z() - a.z * b.y(), a.z * b.x() - a.x * b.z(), a.x * b.y() - a.y * b.x()};
}

}  // namespace tact::correction

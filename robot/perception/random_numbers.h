/// @file
/// Random numbers that are the same on every machine: the standard library leaves its distributions open.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>

namespace tact::perception {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double Uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// Gaussian of mean 0 and deviation 1 [Box and Muller].
  double Gaussian() {
    const double radius = std::sqrt(-2 * std::log1p(-Uniform()));
    return radius * std::cos(2 * M_PI * Uniform());
  }

  /// Uniform on the sphere of radius 1.
  Eigen::Vector3d Direction() {
    for (;;) {
      const Eigen::Vector3d v = InBall();
      constexpr double kTooNear = 1e-6;  // the centre has no direction, and few digits near it
      if (v.norm() > kTooNear) return v.normalized();
    }
  }

  /// Uniform in the ball of radius 1.
  Eigen::Vector3d InBall() {
    for (;;) {
      const Eigen::Vector3d v(2 * Uniform() - 1, 2 * Uniform() - 1, 2 * Uniform() - 1);
      if (v.squaredNorm() <= 1) return v;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tact::perception

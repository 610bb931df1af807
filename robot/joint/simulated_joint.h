/// @file
/// Joints and noisy poses of them, drawn from a seed.
/// Model   Noise is Gaussian with kScale, or the thesis' law [thesis, 4.5.2], whose root mean square a component is the
///         same.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "robot/joint/maximum_likelihood.h"

namespace tact::joint {

enum class NoiseLaw { kNone, kGaussian, kRectangular };

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr double kLargestTurn = 5 * kDegree, kLargestMove = 0.01;  // of the rectangular law
inline constexpr NoiseScale kScale{kLargestTurn / 3, kLargestMove / 3};

class Simulation {
 public:
  explicit Simulation(unsigned seed) : engine_(seed) {}

  double Uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(engine_); }
  Eigen::Vector3d Normal() {
    std::normal_distribution<> normal;
    return {normal(engine_), normal(engine_), normal(engine_)};
  }
  Eigen::Vector3d Direction() { return Normal().normalized(); }
  Transform Frame(double reach) {
    return {RotationExp(Uniform(0, std::numbers::pi) * Direction()), reach * Direction()};
  }
  Joint AnyJoint(JointType type, double reach = 0.1) {
    Joint joint{type, Frame(reach), Frame(reach), 0, 0};
    if (type == JointType::kScrew) joint.pitch = 0.02;
    if (type == JointType::kTwoAxis) joint.offset = 0.03;
    return joint;
  }
  // Where a recording is after a part of it: a quarter turn or 0.2 m in all, other coordinates anywhere.
  Coordinates AnyCoordinates(JointType type, double part) {
    const double turn = std::numbers::pi / 2;
    switch (type) {
      case JointType::kPrismatic:
        return {0.2 * part, 0, 0};
      case JointType::kCylindrical:
        return {turn * part, Uniform(0, 0.2), 0};
      case JointType::kSpherical:
        return turn * Coordinates(Uniform(-0.5, 0.5), Uniform(-0.5, 0.5), Uniform(-0.5, 0.5));
      case JointType::kPlanar:
        return {turn * part, Uniform(0, 0.2), Uniform(0, 0.2)};
      case JointType::kTwoAxis:
        return {Uniform(0, turn), Uniform(-turn / 2, turn / 2), 0};
      default:
        return {turn * part, 0, 0};
    }
  }
  Transform Noisy(const Transform& X, NoiseLaw law) {
    if (law == NoiseLaw::kNone) return X;
    if (law == NoiseLaw::kGaussian) {
      return {RotationExp(kScale.rotation * Normal()) * X.R, X.p + kScale.translation * Normal()};
    }
    return {RotationExp(Uniform(0, kLargestTurn) * Direction()) * X.R,
            X.p + Uniform(0, kLargestMove) * Direction()};
  }
  std::vector<Transform> Poses(const Joint& joint, int count, NoiseLaw law) {
    std::vector<Transform> poses;
    for (int i = 0; i < count; ++i) {
      const double part = static_cast<double>(i) / (count - 1);
      poses.push_back(Noisy(PoseAt(joint, AnyCoordinates(joint.type, part)), law));
    }
    return poses;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tact::joint

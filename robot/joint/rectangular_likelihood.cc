#include "robot/joint/rectangular_likelihood.h"

#include <cmath>

namespace tact::joint {
namespace {

using Eigen::Vector3d;

constexpr double kOutside = 1e3;     // nat a pose outside
constexpr double kLeastPole = 1e-9;  // radian or metre: rounding keeps poles finite
constexpr double kStill = 1e-9;      // metre or radian a unit of the coordinate: it does not move this error

// An error along the coordinate x: |error - x along|^2 = along^2 ((x - best)^2 + rest^2), inside while |x - best| <
// reach.
struct Line {
  double along, best, rest, reach;
};

// Of an error that the coordinate moves; reach negative if it never gets inside: by how much of the bound.
Line LineOf(const Vector3d& error, const Vector3d& along, double bound) {
  const double square = along.squaredNorm(), length = std::sqrt(square);
  const double best = along.dot(error) / square;
  const double rest = std::max(kLeastPole, (error - best * along).norm()) / length;
  const double radius = bound / length;
  return {length, best, rest, rest < radius ? std::sqrt(radius * radius - rest * rest) : 1 - rest / radius};
}

// Integral of 1 / ((x^2 + a^2) ((x - x0)^2 + c^2)) from low to high.
double Integral(double a, double c, double x0, double low, double high) {
  const double offset = x0 * x0, sum = a + c, difference = a - c;
  const double denominator = (offset + sum * sum) * (offset + difference * difference);
  const auto angle = [](double from, double to, double half) {
    return std::atan2(half * (to - from), half * half + to * from) / half;
  };
  const double first = angle(low, high, a), second = angle(low - x0, high - x0, c);
  const double y_high = high - x0, y_low = low - x0;
  const double logs = std::log((high * high + a * a) * (y_low * y_low + c * c) /
                               ((y_high * y_high + c * c) * (low * low + a * a)));
  const double value = x0 * logs + (offset + c * c - a * a) * first + (offset + a * a - c * c) * second;
  // Both poles in one place: the fractions cancel, and the integrand is nearly flat in units of them.
  if (!(denominator > 1e-12 * std::pow(a * a + c * c, 2)) || !(value > 0)) {
    const double middle = (low + high) / 2, y = middle - x0;
    return (high - low) / ((middle * middle + a * a) * (y * y + c * c));
  }
  return value / denominator;
}

double Outside(double excess) { return -kOutside * (1 + excess); }

// Of an error that no coordinate moves.
double LogFixed(const Vector3d& error, double bound) {
  const double square = error.squaredNorm();
  if (square >= bound * bound) return Outside(std::sqrt(square) / bound - 1);
  return -std::log(std::max(square, kLeastPole * kLeastPole));
}

// Of an error that the coordinate moves, alone.
double LogAlong(const Vector3d& error, const Vector3d& along, double bound) {
  const Line line = LineOf(error, along, bound);
  if (line.reach < 0) return Outside(-line.reach);
  return std::log(2 * std::atan(line.reach / line.rest) / line.rest) - 2 * std::log(line.along);
}

}  // namespace

RectangularLikelihood::RectangularLikelihood(const JointFit& fit, std::span<const Transform> poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const JointJacobian jacobian = JacobianAt(fit.joint, fit.coordinates[i]);
    Pose pose{PoseError(fit.joint, fit.coordinates[i], poses[i]), jacobian.parameters, Vector3d::Zero(),
              Vector3d::Zero()};
    if (jacobian.coordinates.cols() > 0) {
      pose.z = jacobian.coordinates.col(0).head<3>();
      pose.m = jacobian.coordinates.col(0).tail<3>();
    }
    least_.rotation = std::max(least_.rotation, pose.error.head<3>().norm());
    least_.translation = std::max(least_.translation, pose.error.tail<3>().norm());
    poses_.push_back(pose);
  }
}

double RectangularLikelihood::LogOf(const Pose& pose, const ParameterVector& change,
                                    const NoiseBounds& bounds) {
  const Vector6 error = pose.error - pose.parameters * change;
  const Vector3d w = error.head<3>(), d = error.tail<3>();
  const bool turns = pose.z.norm() > kStill, moves = pose.m.norm() > kStill;
  if (!turns || !moves) {
    return (turns ? LogAlong(w, pose.z, bounds.rotation) : LogFixed(w, bounds.rotation)) +
           (moves ? LogAlong(d, pose.m, bounds.translation) : LogFixed(d, bounds.translation));
  }
  const Line turn = LineOf(w, pose.z, bounds.rotation), move = LineOf(d, pose.m, bounds.translation);
  if (turn.reach < 0 || move.reach < 0)
    return Outside(std::max(0.0, -turn.reach) + std::max(0.0, -move.reach));
  const double x0 = move.best - turn.best;
  const double low = std::max(-turn.reach, x0 - move.reach), high = std::min(turn.reach, x0 + move.reach);
  if (low >= high) return Outside((low - high) / (turn.reach + move.reach));
  return std::log(Integral(turn.rest, move.rest, x0, low, high)) - 2 * std::log(turn.along * move.along);
}

double RectangularLikelihood::At(const ParameterVector& change, const NoiseBounds& bounds) const {
  double sum =
      -static_cast<double>(poses_.size()) * (std::log(bounds.rotation) + std::log(bounds.translation));
  for (const Pose& pose : poses_) sum += LogOf(pose, change, bounds);
  return sum;
}

std::size_t RectangularLikelihood::PosesOutside(const ParameterVector& change,
                                                const NoiseBounds& bounds) const {
  std::size_t count = 0;
  for (const Pose& pose : poses_) count += LogOf(pose, change, bounds) < -kOutside / 2;
  return count;
}

}  // namespace tact::joint

#include "robot/joint/held_back.h"

#include "robot/joint/likelihood_climb.h"
#include "robot/joint/pose_equations.h"

namespace tact::joint {
namespace {

constexpr int kMostSteps = 20;        // of Gauss and Newton's method, which needs three or four
constexpr double kSmallStep = 1e-10;  // radian, metre: far below any noise

Coordinates NearestCoordinates(const Joint& joint, const NoiseScale& noise, const Transform& pose,
                               Coordinates q) {
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Vector3d change = EquationsAt(joint, q, pose, noise).step;
    q = Changed(joint, q, change);
    if (change.norm() < kSmallStep) break;
  }
  return q;
}

}  // namespace

PoseErrors ErrorsOf(const Joint& joint, const NoiseScale& noise, std::span<const Transform> poses) {
  const std::vector<Coordinates> starts =
      CoordinatesAlong(joint, poses);  // a screw's angle has a turn of its own
  PoseErrors errors;
  for (size_t i = 0; i < poses.size(); ++i) {
    const Vector6 error = PoseError(joint, NearestCoordinates(joint, noise, poses[i], starts[i]), poses[i]);
    errors.rotation.push_back(error.head<3>().norm());
    errors.translation.push_back(error.tail<3>().norm());
  }
  return errors;
}

PoseErrors PredictHeldBack(std::span<const Transform> poses, const Estimator& estimate) {
  PoseErrors all{std::vector<double>(poses.size()), std::vector<double>(poses.size())};
  for (size_t fold = 0; fold < kFolds; ++fold) {
    std::vector<Transform> known;
    for (size_t i = 0; i < poses.size(); ++i) {
      if (i % kFolds != fold) known.push_back(poses[i]);
    }
    const JointFit fit = estimate(known);
    const PoseErrors errors = ErrorsOf(fit.joint, fit.noise, poses);
    for (size_t i = fold; i < poses.size(); i += kFolds) {
      all.rotation[i] = errors.rotation[i];
      all.translation[i] = errors.translation[i];
    }
  }
  return all;
}

}  // namespace tact::joint

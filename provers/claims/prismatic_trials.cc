#include "provers/claims/prismatic_trials.h"

#include <mutex>

#include "robot/joint/thesis_estimator.h"

namespace tact::provers {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The orientation nearest to all poses' among those with the yaw and roll of the first.
Matrix3d PitchOnly(const std::vector<joint::Transform>& poses) {
  Vector3d angles = joint::AnglesOf(poses.front().R);
  Matrix3d sum = Matrix3d::Zero();
  for (const joint::Transform& X_BA : poses) sum += X_BA.R;
  const Matrix3d pitch = joint::RollPitchYaw({angles[0], 0, 0}).transpose() * sum *
                         joint::RollPitchYaw({0, 0, angles[2]}).transpose();
  angles[1] = std::atan2(pitch(0, 2) - pitch(2, 0), pitch(0, 0) + pitch(2, 2));
  return joint::RollPitchYaw(angles);
}

void Measure(const TrialSetup& setup, std::uint64_t seed, double* values) {
  const Trial trial = DrawTrial(setup, seed);
  const joint::Joint found = FitAsInThesis(setup.type, trial.noisy).joint;
  const Vector3d true_A = trial.truth.X_AJ.R.col(2), l_B = found.X_BJ.R.col(2);
  values[kDirectionA] = LineAngle(found.X_AJ.R.col(2), true_A) / kDegree;
  values[kDirectionB] = LineAngle(l_B, trial.truth.X_BJ.R.col(2)) / kDegree;
  values[kFirstPoseA] = LineAngle(trial.noisy.front().R.transpose() * l_B, true_A) / kDegree;
  values[kPitchOnlyA] = LineAngle(PitchOnly(trial.noisy).transpose() * l_B, true_A) / kDegree;
  values[kDifference] = values[kDirectionA] - values[kDirectionB];
}

PrismaticCells Run(Placing placing, Effort effort) {
  PrismaticCells nine;
  size_t i = 0;
  for (const int length : kLengths) {
    for (const int poses : kPoseCounts) {
      const TrialSetup setup{joint::JointType::kPrismatic, length * kMillimetre, poses, placing, 0, 0};
      const auto rows = RunTrials(TrialsFor(effort), kPrismaticValues,
                                  [&](std::uint64_t seed, double* values) { Measure(setup, seed, values); });
      for (size_t k = 0; k < kPrismaticValues; ++k) nine[i][k] = MomentsOf(rows[k]);
      ++i;
    }
  }
  return nine;
}

}  // namespace

const PrismaticCells& PrismaticCellsFor(Placing placing, Effort effort) {
  static std::array<PrismaticCells, 6> all;
  static std::array<std::once_flag, 6> done;
  const size_t at = 2 * static_cast<size_t>(effort) + (placing == Placing::kEqual ? 0 : 1);
  std::call_once(done[at], [&] { all[at] = Run(placing, effort); });
  return all[at];
}

}  // namespace tact::provers

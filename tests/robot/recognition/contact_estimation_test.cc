#include "robot/recognition/contact_estimation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "robot/input/recorded_demonstration.h"
#include "robot/recognition/posed_models.h"
#include "tests/robot/recognition/solids.h"

namespace tact::recognition {
namespace {

using Eigen::Matrix3d;
using input::RecordedDemonstration;
using joint::Transform;

EstimationRule Rule(double noise, double threshold, double reward) {
  EstimationRule rule;
  rule.noise = noise;
  rule.threshold = threshold;
  rule.reward = reward;
  return rule;
}

// A cube over a plate, sunk by 0.1 and turned a little: lying flat takes three DOFs.
TEST(ContactEstimation, ACubeOnAPlateLiesFlat) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const Transform X{joint::RotationExp({0.03, -0.02, 0.5}), {0.5, 0.3, 1.9}};
  const SceneEstimate estimate = EstimateContacts(cube, plate, X, Rule(0.1, 0.3, 6));
  EXPECT_EQ(estimate.near.size(), 4U);
  ASSERT_FALSE(estimate.candidates.empty());
  const ContactCandidate& best = estimate.candidates.front();
  EXPECT_EQ(best.restricted, 3);
  EXPECT_EQ(best.contacts.size(), 4U);
  EXPECT_NEAR(best.X_FM.p.z(), 2, 1e-6);    // by hand: half the plate and half the cube
  EXPECT_NEAR(best.X_FM.R(2, 2), 1, 1e-9);  // flat
  EXPECT_NEAR(std::atan2(best.X_FM.R(1, 0), best.X_FM.R(0, 0)), 0.5,
              1e-3);  // no turn that no contact asks for
  EXPECT_LT(best.overlap, 1e-6);
  EXPECT_TRUE(std::is_sorted(estimate.candidates.begin(), estimate.candidates.end(),
                             [](const auto& a, const auto& b) { return a.cost < b.cost; }));
}

TEST(ContactEstimation, FarAwayNothingTouches) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const SceneEstimate estimate =
      EstimateContacts(cube, plate, {Matrix3d::Identity(), {0, 0, 5}}, Rule(0.1, 0.3, 6));
  EXPECT_TRUE(estimate.near.empty());
  ASSERT_EQ(estimate.candidates.size(), 1U);
  EXPECT_TRUE(estimate.candidates[0].contacts.empty());
  EXPECT_EQ(estimate.candidates[0].cost, 0);
}

// Nearer than the way a reward pays for, a contact is believed; farther, it is not.
TEST(ContactEstimation, TheThresholdIsWhereAContactIsWorthItsWay) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  RecordedDemonstration recording;
  recording.scenes.resize(1);
  EstimationOptions options;
  options.noise = 0.05;
  const EstimationRule rule = MakeRule(recording, cube, plate, options);
  EXPECT_NEAR(rule.threshold, rule.noise * std::sqrt(rule.reward), 1e-12);
  const double turn = std::atan(std::sqrt(2));  // a corner down
  const Matrix3d R = joint::RotationExp(turn * Eigen::Vector3d(1, -1, 0).normalized());
  for (const double share : {0.9, 1.1}) {
    const Transform X{R, {0, 0, 1 + std::sqrt(3) + share * rule.threshold}};
    const SceneEstimate estimate = EstimateContacts(cube, plate, X, rule);
    EXPECT_EQ(estimate.candidates.front().contacts.size(), share < 1 ? 1U : 0U) << share;
  }
}

TEST(ContactEstimation, NoiseIsTheLargerOfScatterAndOverlap) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  RecordedDemonstration recording;
  for (int i = 0; i < 9; ++i) {
    input::RecordedScene scene;
    scene.X_FM = {Matrix3d::Identity(), {0, 0, 1.9}};  // four corners 0.1 deep
    scene.X_CF = Transform{Matrix3d::Identity(), {0, 0, 0}};
    recording.scenes.push_back(scene);
  }
  const NoiseLevel still = MeasureNoise(recording, cube, plate);
  EXPECT_NEAR(*still.repeatability, 0, 1e-12);
  EXPECT_EQ(still.overlaps, 36U);
  EXPECT_NEAR(*still.overlap, 0.1 / 0.6745, 1e-9);
  EXPECT_EQ(still.deviation(), still.overlap);
  for (auto& scene : recording.scenes) scene.X_FM.p.z() = 3;
  EXPECT_FALSE(MeasureNoise(recording, cube, plate).overlap);
  for (auto& scene : recording.scenes) scene.X_CF.reset();
  EXPECT_FALSE(MeasureNoise(recording, cube, plate).deviation());
  EXPECT_NE(MakeRule(recording, cube, plate).why.find("tells no noise"), std::string::npos);
}

// What a person sees [its README: no clearance]: free at first, then a corner, at last seated.
TEST(ContactEstimation, ThePublishedRecordingBeginsFreeAndEndsSeated) {
  const std::string path = std::string(TACT_SOURCE_DIR) + "/../shared/data/peg_in_hole/peg_in_hole.pose.list";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data here";
  const RecordedDemonstration recording = input::ReadRecording(path);
  const ModelPair models = LoadModels(recording.models);
  const ProximitySolid moving(models.moving), fixed(models.fixed);
  const EstimationRule rule = MakeRule(recording, moving, fixed);
  EXPECT_GT(rule.threshold, 1);  // millimetre
  EXPECT_LT(rule.threshold, 10);
  const auto taken = [&](size_t scene) {
    return EstimateContacts(moving, fixed, recording.scenes[scene - 1].X_FM, rule)
        .candidates.front()
        .restricted;
  };
  EXPECT_EQ(taken(1), 0);
  EXPECT_EQ(taken(5), 0);
  EXPECT_GT(taken(24), 0);
  EXPECT_EQ(taken(41), 5);  // all but the way along z
}

}  // namespace
}  // namespace tact::recognition

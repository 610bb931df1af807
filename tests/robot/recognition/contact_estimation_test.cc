#include "robot/recognition/contact_estimation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/input/recorded_demonstration.h"
#include "tests/robot/recognition/solids.h"

namespace tact::recognition {
namespace {

using Eigen::Matrix3d;
using input::RecordedDemonstration;
using joint::Transform;

// A cube over a plate, sunk by 0.1 and turned a little: its four lower corners.
TEST(ContactEstimation, ACubeOnAPlateHasFourCornersWithinTheThreshold) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const Transform X{joint::RotationExp({0.03, -0.02, 0.5}), {0.5, 0.3, 1.9}};
  EXPECT_EQ(EstimateContacts(cube, plate, X, 0.3).size(), 4U);
  EXPECT_TRUE(EstimateContacts(cube, plate, {Matrix3d::Identity(), {0, 0, 5}}, 0.3).empty());
}

// Where what speaks for a contact equals what speaks against it, by hand: 2 ln(w / (s sqrt(2 pi))) = (t / s)^2.
TEST(ContactEstimation, TheThresholdIsWhereAContactIsWorthItsWay) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  RecordedDemonstration recording;
  recording.scenes.resize(1);
  EstimationOptions options;
  options.noise = 0.05;
  const EstimationRule rule = MakeRule(recording, cube, plate, options);
  EXPECT_NEAR(rule.threshold, 0.05 * std::sqrt(2 * std::log(std::sqrt(132) / (0.05 * std::sqrt(2 * M_PI)))),
              1e-12);
  options.threshold = 0.2;
  EXPECT_EQ(MakeRule(recording, cube, plate, options).threshold, 0.2);
  EXPECT_NE(MakeRule(recording, cube, plate, options).why.find("by hand"), std::string::npos);
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

}  // namespace
}  // namespace tact::recognition

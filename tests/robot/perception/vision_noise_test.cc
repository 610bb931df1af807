#include "robot/perception/vision_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/perception/random_numbers.h"

namespace tact::perception {
namespace {

using joint::Transform;

constexpr int kDraws = 20000;

// [thesis, 4.5.2]: sizes uniform up to the bound, of mean half of it and mean square a third; directions uniform, so each
// component's mean is zero and its mean square a third of the size's. Five deviations of the means of that many draws.
TEST(VisionNoise, HasTheThesisLaw) {
  const VisionNoise most{0.2, 7};
  RandomNumbers random(1);
  double turn = 0, turn2 = 0, shift = 0, shift2 = 0;
  Eigen::Vector3d turns = Eigen::Vector3d::Zero(), shifts = Eigen::Vector3d::Zero();
  const Transform X{joint::RotationExp({1, -0.5, 0.3}), {4, 5, 6}};
  for (int i = 0; i < kDraws; ++i) {
    const Transform noisy = AddVisionNoise(X, most, random);
    const Eigen::Vector3d w = joint::RotationLog(noisy.R * X.R.transpose()), d = noisy.p - X.p;
    ASSERT_LE(w.norm(), most.turn + 1e-12);
    ASSERT_LE(d.norm(), most.shift + 1e-12);
    turn += w.norm() / kDraws, turn2 += w.squaredNorm() / kDraws;
    shift += d.norm() / kDraws, shift2 += d.squaredNorm() / kDraws;
    turns += w / kDraws, shifts += d / kDraws;
  }
  const double five = 5 / std::sqrt(kDraws);
  EXPECT_NEAR(turn, most.turn / 2, five * most.turn / std::sqrt(12));
  EXPECT_NEAR(shift, most.shift / 2, five * most.shift / std::sqrt(12));
  EXPECT_NEAR(turn2, most.turn * most.turn / 3, five * most.turn * most.turn * std::sqrt(4.0 / 45));
  EXPECT_NEAR(shift2, most.shift * most.shift / 3, five * most.shift * most.shift * std::sqrt(4.0 / 45));
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(turns[k], 0, five * most.turn / 3);
    EXPECT_NEAR(shifts[k], 0, five * most.shift / 3);
  }
}

TEST(VisionNoise, OneSeedOneNoise) {
  input::RecordedDemonstration recording;
  recording.scenes.resize(5);
  const auto a = MakeNoisy(recording, {0.1, 1}, 3), b = MakeNoisy(recording, {0.1, 1}, 3),
             c = MakeNoisy(recording, {0.1, 1}, 4);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(a.scenes[i].X_FM.p, b.scenes[i].X_FM.p);
    EXPECT_NE(a.scenes[i].X_FM.p, c.scenes[i].X_FM.p);
    EXPECT_NE(a.scenes[i].X_FM.p, a.scenes[(i + 1) % 5].X_FM.p);
  }
}

TEST(VisionNoise, NoNoiseChangesNothing) {
  RandomNumbers random(9);
  const Transform X{joint::RotationExp({0.1, 0.2, 0.3}), {1, 2, 3}};
  const Transform same = AddVisionNoise(X, {0, 0}, random);
  EXPECT_EQ(same.p, X.p);
  EXPECT_LT((same.R - X.R).norm(), 1e-15);
}

}  // namespace
}  // namespace tact::perception

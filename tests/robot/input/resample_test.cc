#include "robot/input/resample.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/error.h"

namespace tact::input {
namespace {

using joint::Transform;

// A turn about z by a tenth of a radian and a step of (1, 2, 0) from scene to scene; times, if any, two seconds apart.
RecordedDemonstration Spiral(size_t count, bool timed) {
  RecordedDemonstration recording;
  for (size_t i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i);
    RecordedScene scene;
    scene.name = "s" + std::to_string(i);
    if (timed) scene.time = 5 + 2 * k;
    scene.X_FM = {joint::RotationExp({0, 0, 0.1 * k}), {k, 2 * k, 0}};
    scene.X_CF = scene.X_FM;
    recording.scenes.push_back(scene);
  }
  return recording;
}

TEST(Resample, EveryKthSceneStaysAsItIs) {
  const RecordedDemonstration third = EveryKth(Spiral(8, true), 3);
  ASSERT_EQ(third.scenes.size(), 3U);
  EXPECT_EQ(third.scenes[1].name, "s3");
  EXPECT_EQ(third.scenes[2].time, 17);
  EXPECT_EQ(EveryKth(Spiral(8, true), 100).scenes.size(), 1U);
  EXPECT_THROW(EveryKth(Spiral(8, true), 0), PreconditionError);
}

// On a path that is even between scenes every sample lies on it, by hand: at k the angle is 0.1 k.
TEST(Resample, EvenTimesLieOnTheScrewBetweenScenes) {
  for (const bool timed : {true, false}) {
    const RecordedDemonstration even = AtEvenTimes(Spiral(4, timed), 7);
    ASSERT_EQ(even.scenes.size(), 7U);
    for (size_t i = 0; i < 7; ++i) {
      const double k = 0.5 * static_cast<double>(i);
      const Transform& X = even.scenes[i].X_FM;
      EXPECT_NEAR((X.R - joint::RotationExp({0, 0, 0.1 * k})).norm(), 0, 1e-12);
      EXPECT_NEAR((X.p - Eigen::Vector3d(k, 2 * k, 0)).norm(), 0, 1e-12);
      EXPECT_EQ(even.scenes[i].time.has_value(), timed);
      if (timed) {
        EXPECT_NEAR(*even.scenes[i].time, 5 + 2 * k, 1e-12);
      }
      EXPECT_NEAR((even.scenes[i].X_CF->p - X.p).norm(), 0, 1e-12);
    }
    EXPECT_EQ(even.scenes[2].name, "s1");  // just such a time: as it is
    EXPECT_EQ(even.scenes[6].name, "s3");
  }
}

TEST(Resample, TheShorterTurnIsTaken) {
  const Transform a{joint::RotationExp({0, 0, 3}), {0, 0, 0}}, b{joint::RotationExp({0, 0, -3}), {0, 0, 0}};
  const Transform middle = Interpolate(a, b, 0.5);
  EXPECT_NEAR((middle.R - joint::RotationExp({0, 0, M_PI})).norm(), 0, 1e-9);
}

TEST(Resample, OneSceneStaysOne) {
  EXPECT_EQ(AtEvenTimes(Spiral(1, true), 5).scenes.size(), 1U);
  EXPECT_THROW(AtEvenTimes(Spiral(2, true), 1), PreconditionError);
}

}  // namespace
}  // namespace tact::input

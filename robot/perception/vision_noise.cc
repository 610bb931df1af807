#include "robot/perception/vision_noise.h"

#include "robot/perception/random_numbers.h"

namespace tact::perception {

input::RecordedDemonstration MakeNoisy(input::RecordedDemonstration recording, const VisionNoise& most,
                                       std::uint64_t seed) {
  RandomNumbers random(seed);
  for (input::RecordedScene& scene : recording.scenes) {
    scene.X_FM = AddVisionNoise(scene.X_FM, most, random);
    scene.X_CF.reset();
    scene.exact.reset();
  }
  return recording;
}

}  // namespace tact::perception

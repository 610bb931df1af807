#include "robot/input/resample.h"

#include <algorithm>

#include "algebra/error.h"

namespace tact::input {

using joint::Transform;

Transform Interpolate(const Transform& a, const Transform& b, double share) {
  return {a.R * joint::RotationExp(share * joint::RotationLog(a.R.transpose() * b.R)),
          a.p + share * (b.p - a.p)};
}

RecordedDemonstration EveryKth(const RecordedDemonstration& recording, size_t k) {
  if (k < 1) throw PreconditionError("every 0th scene");
  RecordedDemonstration result = recording;
  result.scenes.clear();
  for (size_t i = 0; i < recording.scenes.size(); i += k) result.scenes.push_back(recording.scenes[i]);
  return result;
}

RecordedDemonstration AtEvenTimes(const RecordedDemonstration& recording, size_t count) {
  const std::vector<RecordedScene>& scenes = recording.scenes;
  if (scenes.size() <= 1) return recording;
  if (count < 2) throw PreconditionError("fewer than two scenes at even times");
  std::vector<double> times;
  for (const RecordedScene& scene : scenes)
    times.push_back(scene.time.value_or(static_cast<double>(times.size())));
  RecordedDemonstration result = recording;
  result.scenes.clear();
  size_t at = 0;  // the last scene not after the time
  for (size_t i = 0; i < count; ++i) {
    const double share_of_all = static_cast<double>(i) / static_cast<double>(count - 1);
    const double time =
        i + 1 == count ? times.back() : times.front() + share_of_all * (times.back() - times.front());
    while (at + 1 < scenes.size() && times[at + 1] <= time) ++at;
    if (times[at] == time) {
      result.scenes.push_back(scenes[at]);
      continue;
    }
    const RecordedScene &a = scenes[at], &b = scenes[at + 1];
    const double share = (time - times[at]) / (times[at + 1] - times[at]);
    RecordedScene scene;
    scene.name = std::to_string(i + 1);
    if (a.time) scene.time = time;
    scene.X_FM = Interpolate(a.X_FM, b.X_FM, share);
    if (a.X_CF && b.X_CF) scene.X_CF = Interpolate(*a.X_CF, *b.X_CF, share);
    scene.where = a.where;
    result.scenes.push_back(std::move(scene));
  }
  return result;
}

}  // namespace tact::input

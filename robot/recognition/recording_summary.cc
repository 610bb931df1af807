#include "robot/recognition/recording_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algebra/error.h"
#include "robot/recognition/noise_level.h"
#include "robot/recognition/pose_metric.h"

namespace tact::recognition {
namespace {

using input::RecordedDemonstration;
using input::RecordedScene;

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string UnitOf(const RecordedDemonstration& recording) {
  return std::string(ToString(recording.models.unit));
}

void AddGaps(const RecordedDemonstration& recording, std::vector<std::string>* doubts) {
  const auto& scenes = recording.scenes;
  std::vector<double> steps;
  for (size_t i = 1; i < scenes.size(); ++i) {
    if (!scenes[i].time || !scenes[i - 1].time) return;
    steps.push_back(*scenes[i].time - *scenes[i - 1].time);
  }
  if (steps.size() < 3) return;
  const auto widest = std::max_element(steps.begin(), steps.end());
  if (*widest <= kWideGap * Median(steps)) return;
  const RecordedScene& before = scenes[static_cast<size_t>(widest - steps.begin())];
  doubts->push_back("after scene " + before.name + " (" + before.where + ") nothing was seen for " +
                    Number(*widest) + " s; what happened there is not in the recording");
}

// A pose that is far from both neighbours, which are near each other.
void AddOutliers(const RecordedDemonstration& recording, const PoseMetric& metric,
                 std::vector<std::string>* doubts) {
  const auto& scenes = recording.scenes;
  std::vector<double> steps;
  for (size_t i = 1; i < scenes.size(); ++i)
    steps.push_back(metric.Distance(scenes[i - 1].X_FM, scenes[i].X_FM));
  if (steps.size() < 4) return;
  const double usual = Median(steps);
  for (size_t i = 1; i + 1 < scenes.size(); ++i) {
    const double away = std::min(steps[i - 1], steps[i]);
    if (away <= kWideGap * usual || metric.Distance(scenes[i - 1].X_FM, scenes[i + 1].X_FM) > away / 2)
      continue;
    doubts->push_back("scene " + scenes[i].name + " (" + scenes[i].where + ") lies " + Number(away) + " " +
                      UnitOf(recording) + " off its neighbours: is it an outlier?");
  }
}

void AddFixedMoves(const RecordedDemonstration& recording, const PoseMetric& metric, double scatter,
                   std::vector<std::string>* doubts) {
  const RecordedScene* last = nullptr;
  for (const RecordedScene& scene : recording.scenes) {
    if (scene.X_CF && last != nullptr) {
      const double way = metric.Distance(*last->X_CF, *scene.X_CF);
      if (way > kFixedMoves * scatter) {
        doubts->push_back("the fixed object moves by " + Number(way) + " " + UnitOf(recording) +
                          " up to scene " + scene.name + " (" + scene.where +
                          "): are the models swapped, or was it moved?");
        return;
      }
    }
    if (scene.X_CF) last = &scene;
  }
}

}  // namespace

RecordingSummary Summarise(const RecordedDemonstration& recording, const ProximitySolid& moving,
                           const ProximitySolid& fixed) {
  if (recording.scenes.empty()) throw PreconditionError("a recording without scenes");
  const PoseMetric metric(moving.solid()), fixed_metric(fixed.solid());
  RecordingSummary summary;
  const joint::Transform& first = recording.scenes.front().X_FM;
  summary.low = summary.high = first.p;
  double nearest = HUGE_VAL;
  const RecordedScene* before = nullptr;
  for (const RecordedScene& scene : recording.scenes) {
    summary.low = summary.low.cwiseMin(scene.X_FM.p);
    summary.high = summary.high.cwiseMax(scene.X_FM.p);
    summary.turn = std::max(summary.turn, joint::RotationLog(first.R.transpose() * scene.X_FM.R).norm());
    if (before != nullptr) summary.path += (scene.X_FM.p - before->X_FM.p).norm();
    before = &scene;
    nearest = std::min(nearest, (scene.X_FM * metric.centroid() - fixed_metric.centroid()).norm());
  }
  const double radii = metric.radius() + fixed_metric.radius();
  if (nearest > kNeverNear * radii) {
    summary.doubts.push_back("the solids are never nearer than " + Number(nearest) + " " + UnitOf(recording) +
                             ", " + Number(nearest / radii) +
                             " times their radii: are unit and frame of the poses right?");
  }
  if (recording.scenes.size() == 1)
    summary.doubts.push_back("there is one scene only: it shows a contact relation, but no transition");
  AddGaps(recording, &summary.doubts);
  AddOutliers(recording, metric, &summary.doubts);
  const NoiseLevel level = MeasureNoise(recording, moving, fixed);
  if (level.repeatability) AddFixedMoves(recording, fixed_metric, *level.repeatability, &summary.doubts);
  return summary;
}

}  // namespace tact::recognition

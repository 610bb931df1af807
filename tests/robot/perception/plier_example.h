/// @file
/// The study whose scans are examples/plier: also a small one for tests, 2700 points a scan.
#pragma once

#include "robot/perception/plier.h"
#include "robot/perception/random_numbers.h"

namespace tact::perception {

/// A camera of a third of the resolution.
inline PlierStudy SmallStudy(std::uint64_t seed, double noise = 2e-4) {
  PlierStudy study;
  study.camera.width = 213;
  study.camera.height = 160;
  study.camera.focal = 647;
  study.camera.noise = noise;
  study.seed = seed;
  return study;
}

inline std::vector<std::vector<Vector3d>> PointsOf(const std::vector<PlierScan>& scans) {
  std::vector<std::vector<Vector3d>> points;
  for (const PlierScan& scan : scans) points.push_back(scan.seen.points);
  return points;
}

}  // namespace tact::perception

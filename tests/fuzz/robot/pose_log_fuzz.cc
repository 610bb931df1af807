// Any bytes are a log of poses, or are refused as bad input with a place. What is read is finite, of unit quaternions, in the
// order of time; a rotation survives as a matrix.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "algebra/error.h"
#include "robot/joint/pose_series.h"

namespace {

using namespace tact;  // NOLINT: a program of one file

void Require(bool holds) {
  if (!holds) std::abort();
}

void Check(const input::PoseLog& log) {
  Require(!log.poses.empty());
  double time = log.poses.front().time;
  for (const input::LoggedPose& pose : log.poses) {
    Require(pose.time >= time && std::isfinite(pose.time));
    time = pose.time;
    double squares = 0;
    for (const double value : pose.rotation) squares += value * value;
    Require(std::abs(squares - 1) < 1e-9);
    for (const double value : pose.location) Require(std::abs(value) <= input::kFarthestLocation);
  }
  const joint::PoseSeries series = joint::SeriesOf(log);
  for (const joint::Transform& pose : series.poses)
    Require((pose.R * pose.R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  for (const std::string& sentence : joint::Suspicions(series)) Require(!sentence.empty());
  Require(joint::SeriesOf(log, log).poses.size() == log.poses.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    Check(input::ReadPoseLog(in, "fuzz"));
  } catch (const InputError& error) {
    Require(std::string(error.what()).starts_with("fuzz:"));
  }
  return 0;
}

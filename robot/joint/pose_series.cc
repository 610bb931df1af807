#include "robot/joint/pose_series.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algebra/error.h"

namespace tact::joint {
namespace {

constexpr double kDegree = 180 / M_PI;

Transform TransformOf(const input::LoggedPose& pose) {
  const auto& [w, x, y, z] = pose.rotation;
  return {Eigen::Quaterniond(w, x, y, z).toRotationMatrix(),
          {pose.location[0], pose.location[1], pose.location[2]}};
}

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

double MedianStep(const std::vector<input::LoggedPose>& poses) {
  std::vector<double> steps;
  for (size_t i = 1; i < poses.size(); ++i) steps.push_back(poses[i].time - poses[i - 1].time);
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

void Append(const input::LoggedPose& a, const Transform& X_BA, bool timed, PoseSeries* series) {
  series->poses.push_back(X_BA);
  series->lines.push_back(a.line);
  if (timed) series->times.push_back(a.time);
}

void AppendPair(const input::LoggedPose& a, const input::LoggedPose& b, bool timed, PoseSeries* series) {
  const Transform X_WB = TransformOf(b);
  series->X_WB.push_back(X_WB);
  Append(a, X_WB.Inverse() * TransformOf(a), timed, series);
}

PoseSeries MatchLineByLine(const input::PoseLog& A_in_W, const input::PoseLog& B_in_W) {
  if (A_in_W.poses.size() != B_in_W.poses.size()) {
    throw InputError(B_in_W.name + ": expected as many poses as " + A_in_W.name + " has, " +
                     std::to_string(A_in_W.poses.size()) +
                     ", for without times in both they are matched line by line, got " +
                     std::to_string(B_in_W.poses.size()));
  }
  PoseSeries series;
  for (size_t i = 0; i < A_in_W.poses.size(); ++i) {
    AppendPair(A_in_W.poses[i], B_in_W.poses[i], A_in_W.has_times, &series);
  }
  series.notes = {"the logs are matched line by line"};
  return series;
}

PoseSeries MatchByTime(const input::PoseLog& A_in_W, const input::PoseLog& B_in_W, double limit) {
  PoseSeries series;
  double widest = 0;
  size_t k = 0;
  for (const input::LoggedPose& a : A_in_W.poses) {
    const auto apart = [&](size_t i) { return std::abs(B_in_W.poses[i].time - a.time); };
    while (k + 1 < B_in_W.poses.size() && apart(k + 1) <= apart(k)) ++k;
    if (apart(k) > limit) continue;
    widest = std::max(widest, apart(k));
    AppendPair(a, B_in_W.poses[k], true, &series);
  }
  if (series.poses.empty()) {
    throw InputError(B_in_W.name + ": expected times of " + A_in_W.name + " within " + Short(limit) +
                     " s, got none; --time-limit allows more");
  }
  series.notes = {std::to_string(series.poses.size()) + " of " + std::to_string(A_in_W.poses.size()) +
                  " poses have a partner in the other log within " + Short(limit) + " s; the widest gap is " +
                  Short(widest) + " s"};
  return series;
}

std::string Lines(const PoseSeries& series, size_t i) {
  return "lines " + std::to_string(series.lines[i - 1]) + " and " + std::to_string(series.lines[i]);
}

void AddWideStep(const PoseSeries& series, std::vector<std::string>* found) {
  double widest = 0;
  size_t at = 0;
  for (size_t i = 1; i < series.poses.size(); ++i) {
    const double angle = RotationLog(series.poses[i - 1].R.transpose() * series.poses[i].R).norm();
    if (angle > widest) widest = angle, at = i;
  }
  if (widest <= kWideStep) return;
  found->push_back("between " + Lines(series, at) + " the link turns by " +
                   std::to_string(static_cast<int>(std::lround(widest * kDegree))) +
                   " degrees; a turn of more than 180 between two poses looks like one the other way");
}

void AddRepeats(const PoseSeries& series, std::vector<std::string>* found) {
  size_t repeats = 0;
  for (size_t i = 1; i < series.poses.size(); ++i) {
    repeats += series.poses[i].R == series.poses[i - 1].R && series.poses[i].p == series.poses[i - 1].p;
  }
  if (repeats == 0) return;
  found->push_back(std::to_string(repeats) + (repeats == 1 ? " pose repeats" : " poses repeat") +
                   " the one before exactly; copies tell nothing new, but count as if they did");
}

void AddUnits(const PoseSeries& series, std::vector<std::string>* found) {
  std::vector<double> distances;
  for (const Transform& pose : series.poses) distances.push_back(pose.p.norm());
  std::sort(distances.begin(), distances.end());
  size_t gap = 0;  // the first of the far group
  double ratio = 0;
  for (size_t i = 1; i < distances.size(); ++i) {
    if (distances[i - 1] > 0 && distances[i] / distances[i - 1] > ratio)
      ratio = distances[i] / distances[i - 1], gap = i;
  }
  if (gap > 0) {
    const double near = distances[gap / 2], far = distances[gap + (distances.size() - gap) / 2];
    if (ratio > kUnitFactorLeast / 3 && far / near > kUnitFactorLeast && far / near < kUnitFactorMost) {
      found->push_back(std::to_string(distances.size() - gap) + " of " + std::to_string(distances.size()) +
                       " locations are about " + Short(far / near) +
                       " times as far from the origin as the others: are units mixed?");
      return;
    }
  }
  const double middle = distances[distances.size() / 2];
  if (middle > kFarAway)
    found->push_back("A is " + Short(middle) + " m away from B: is the unit right (--unit mm)?");
}

}  // namespace

PoseSeries SeriesOf(const input::PoseLog& log, bool inverse) {
  PoseSeries series;
  for (const input::LoggedPose& pose : log.poses) {
    const Transform X = TransformOf(pose);
    Append(pose, inverse ? X.Inverse() : X, log.has_times, &series);
  }
  return series;
}

PoseSeries SeriesOf(const input::PoseLog& A_in_W, const input::PoseLog& B_in_W, std::optional<double> limit) {
  if (!A_in_W.has_times || !B_in_W.has_times) return MatchLineByLine(A_in_W, B_in_W);
  return MatchByTime(A_in_W, B_in_W, limit.value_or(MedianStep(B_in_W.poses) / 2));
}

std::vector<std::string> Suspicions(const PoseSeries& series) {
  std::vector<std::string> found;
  AddWideStep(series, &found);
  AddRepeats(series, &found);
  AddUnits(series, &found);
  return found;
}

}  // namespace tact::joint

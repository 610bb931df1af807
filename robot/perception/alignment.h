/// @file
/// The rigid motion that brings one scan onto another, where only part of it may move that way.
/// Model   iterated closest points, point to plane: each source point's nearest target point within a gate, with a normal
///         alike, pulls it onto that point's plane; weights fall to nothing at the gate [Tukey] and for distances from the
///         plane far beyond the rest's. The gate narrows from step to step, so the motion that the most points agree on wins
///         over the mean of two.
/// Frames  X_TS brings points of the source S into the frame of the target T.
/// Units   those of the points, radian.
/// Promise none that the motion found is the best one: a start within some ten degrees and a gate's length is needed.
/// Cost    a tree question a source point and step.
#pragma once

#include "robot/joint/transform.h"
#include "robot/perception/surface.h"

namespace tact::perception {

/// Two pixels: a scan's points lie this near to the other's where both saw the surface.
inline constexpr double kGateOverSpacing = 2.5;
/// Normals alike: within 32 degrees (sign left open).
inline constexpr double kAlikeCosine = 0.85;

struct Alignment {
  joint::Transform X_TS;
  double inliers = 0;   // share of the source's points that found a partner at the last gate
  double residual = 0;  // of these: a robust standard deviation of the distance from the partner's plane
  // The covariance of X_TS' error for points of unit noise, by the inliers: of the twist [w; v] about the source's origin, in
  // the source's frame, with X_TS found = X_TS true * (1 + twist).
  Eigen::Matrix<double, 6, 6> unit_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  int steps = 0;
  bool converged = false;
};

struct AlignmentOptions {
  double first_gate = 0;  // at the start; 0: the last one
  double last_gate = 0;   // 0: kGateOverSpacing times the target's spacing
  int most_steps = 60;
};

Alignment Align(const Surface& source, const Surface& target, const joint::Transform& start,
                const AlignmentOptions& options = {});

/// The best of several starts: the source's centroid on the target's, turned by -36 to 36 degrees about the direction in which
/// the source is flattest. Best: the most inliers.
Alignment FindAlignment(const Surface& source, const Surface& target);

}  // namespace tact::perception

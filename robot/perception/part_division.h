/// @file
/// Two-part division of a linkage from scans of it in different states, by alignment and subtraction [thesis, 4.5.3].
/// Model   Two scans: the motion that explains the most points is one part's; without these points, the next is the other's.
///         The pair of scans (the first and another) that tells the parts apart best gives the first division; from there on
///         all scans decide together (part_evidence.h): parts and motions in turns until no point changes.
///         The first part is the one with more points in the first scan.
/// Frames  X_S0[part]: the part's motion from the first scan's frame into the scan's.
/// Units   those of the points, radian.
/// Pre     the scans show one object of two rigid parts, nothing else, from about the same side: turned by at most some thirty
///         degrees and shifted by a fraction of its size (alignment.h).
/// Errors  PreconditionError: fewer than two scans; what SurfaceOf refuses.
/// Promise parts that point to parts, not to points: where both motions explain a point (near the axis), or neither does
///         (it was hidden in the other scans), it stays undecided.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/perception/part_evidence.h"

namespace tact::perception {

using Eigen::Vector3d;

/// Parts that turned against one another by less in all scans are not told apart: one degree, at which a hand-sized part's
/// end moves by a few of a scanner's pixels.
inline constexpr double kLeastTurn = 0.0175;  // radian
/// Scans of one object have at least this share of the points in common.
inline constexpr double kLeastShared = 0.5;
/// A part has at least this share of the points.
inline constexpr double kLeastPart = 0.05;

struct DividedScan {
  std::array<joint::Transform, 2> X_S0;
  std::array<double, 2>
      residuals{};  // robust standard deviation of the distance from the first scan's surface
  std::array<Eigen::Matrix<double, 6, 6>, 2> unit_covariances;  // alignment.h
  double noise = 0;                                             // surface.h
  std::vector<Part> parts;                                      // of each point
};

struct Division {
  std::string cannot_tell;  // why; empty: divided
  std::vector<DividedScan> scans;
  int rounds = 0;
};

Division DivideTwoParts(std::span<const std::vector<Vector3d>> scans);

/// How many points are of a part.
std::size_t CountOf(Part part, std::span<const Part> parts);

}  // namespace tact::perception

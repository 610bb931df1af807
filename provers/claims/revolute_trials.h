/// @file
/// The revolute joint's trials of [thesis, 4.5.2], re-run once for all claims about them.
/// Units   degree, millimetre: as printed.
#pragma once

#include <array>
#include <vector>

#include "provers/claims/joint_trials.h"
#include "provers/claims/printed_table.h"

namespace tact::provers {

/// What a trial measures, in link A and in link B.
enum RevoluteValue {
  kAxisA,  // angle between estimated and true axis, conjugate gradients run until they converge
  kAxisB,
  kEarlyAxisA,  // ended where a step lessens the sum by less than kEarlyTolerance of it
  kEarlyAxisB,
  kMethodAxisA,  // Method A, its pair chosen by the noisy angles
  kMethodAxisB,
  kTrueMethodAxisA,  // chosen by the true angles
  kTrueMethodAxisB,
  kLineA,  // distance of the estimated centre from the true axis
  kLineB,
  kPointA,  // distance of the estimated centre from the true one, both moved along the axis alike to lie nearest
  kPointB,
  kGap,  // between the axis that conjugate gradients find and that at the global optimum
  kRevoluteValues
};

inline constexpr double kEarlyTolerance = 3e-5;
inline constexpr std::array kSpans = {45, 90, 180};  // degree

struct RevoluteCell {
  Placing placing = Placing::kEqual;
  int span = 0, poses = 0;
  double distance = 0;  // of the centre from the links' origins
  std::array<Moments, kRevoluteValues> values;
  int far_from_optimum = 0;  // trials in which kGap is above a thousandth of a degree
};

inline constexpr double kNearCentre = 10 * kMillimetre;

/// Both placings with the centre at kNearCentre, then equal steps with it at 0, 30 and 100 mm; spans by poses within
/// each.
const std::vector<RevoluteCell>& RevoluteCellsFor(Effort effort);

/// The nine cells in the order of the tables' rows, 45 degrees with 50, 100, 200 poses first.
std::vector<const RevoluteCell*> NineCells(const std::vector<RevoluteCell>& cells, Placing placing,
                                           double distance);

}  // namespace tact::provers

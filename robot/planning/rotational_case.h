/// @file
/// Which turns lead from one contact relation to the other [thesis, A.4.2, A.6].
/// Model   D = Theta_e Theta_s^T. By rank G_s and rank G_e:
///           case 1, (0, 1 or 2; 3): D itself; the axis has to be in A_s. From 1: two turns, (A.24) or (A.25).
///           case 2, (0; 2): D less its turn about a_1, the basis of A_e (A.20).
///           case 3, (1; 2): D = R(a_1, -beta) R(a_2, alpha), the turn is R(a_2, alpha) (A.21). a_2 completes a_1 in
///             A_s; where a_1 is not in A_s, it is the normal of the one face of the line contact (A.6.2).
///           case 4, (0; 1): with a line contact at the end, about a_3 = n x l until the edge is in the face's plane (A.24)
///             or (A.25) for R(m, beta) in (A.22): of two angles the smaller. Otherwise D's turn about a_3 (A.22).
/// Departs The thesis gives case 1 no condition and calls (A.21) always satisfied; neither is so: both are failures here,
///         named. In case 4 the axis is a_3 at the GIVEN end; where the edge's direction differs from its nearest in
///         the plane, a turn about n x (edge at the start) is smaller: see least_angle.
/// Frames  the fixed solid's.
/// Units   radian.
#pragma once

#include <string>
#include <vector>

#include "robot/planning/over_approximation.h"
#include "robot/planning/rotation_split.h"

namespace tact::planning {

struct TurnProblem {
  Eigen::Matrix3d R_start, R_end;
  Ranks start, end;
  Basis start_axes, end_axes;  // A_s at the start, A_e at the end
  LineContact start_line, end_line;
};

struct TurnAnswer {
  int number = 0;           // of the case; 0: none, the ranks are no rotational case
  std::string cure;         // "A.6.1 edge-face" and so on; "" where A.4.2 will do
  std::vector<Turn> turns;  // in the order in which they are made; none of angle zero
  std::string failure;      // why there are none
  /// Case 4 with a line contact: the least angle of any turn that brings the edge into the plane. Otherwise that of `turns`.
  double least_angle = 0;
};

TurnAnswer RotationalCase(const TurnProblem& problem);

}  // namespace tact::planning

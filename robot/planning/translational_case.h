/// @file
/// The straight line of a translational case [thesis, A.3].
/// Model   Delta t_d leads to where C_e holds and is perpendicular to T_e, the null space of F_e (A.10). By rank F_e:
///         case 1, rank 3: t_e - t_s (A.11). Case 2, rank 2: t_e + u t_r - t_s, u by (A.14). Case 3, rank 1:
///         u (Delta t_1 x Delta t_2) (A.15). One of these is what rank F_e asks for, whatever rank F_s is: the pairs of
///         equal ranks, which Table A.1 leaves out, are no different; with rank F_e = 0 nothing moves.
///         Of all straight lines from t_s to locations where C_e holds it is the shortest, for these are t_e + T_e.
/// Frames  the fixed solid's.
#pragma once

#include <string>

#include "robot/planning/motion_rows.h"

namespace tact::planning {

struct Straight {
  int number = 0;  // of the case; 0: nothing is asked
  Eigen::Vector3d displacement{0, 0, 0};
  /// The rate of a maintained gap along the line: the largest share of the displacement that F_s does not allow.
  double off_start = 0;
};

/// p_s is the location at the start, p_e any location where C_e holds; the rows are those of the one orientation.
Straight TranslationalCase(const Eigen::Vector3d& p_s, const Eigen::Vector3d& p_e, const MotionRows& start,
                           const MotionRows& end);

}  // namespace tact::planning

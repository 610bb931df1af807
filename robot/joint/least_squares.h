/// @file
/// Joints by least squares of orientation first and of location then, as chapter 4 of the thesis sets them up, each at
/// its global optimum.
/// Model   prismatic    sum of 1 - cos of the angles between orientations [thesis, eq. (4.6)]: a singular value
///                      decomposition of the sum of orientations; direction by principal components [eq. (4.7)]
///         revolute     sum of 1 - cos of the angles between l_B and R_i l_A [eq. (4.16)]: l_B . (sum of R_i) l_A is
///                      largest at the first singular vectors; centre by linear least squares with the corrected
///                      orientations [eq. (4.18)]
///         screw        axis as revolute; centre and pitch by linear least squares [eq. (4.24)], angles unwrapped along
///                      the poses' order [eq. (4.21)]
///         two-axis     sum of (u . R_i v)^2 [eq. (4.38)] by two_axis_search.h; centres and offset linear
///         the others   alike: rigid, spherical (linear), cylindrical, planar.
/// Pre     at least one pose.
/// Errors  none: where the poses leave something open, the answer is one of many (maximum_likelihood.h tells).
/// Cost    O(N) time in two or three passes, O(1) memory.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "robot/joint/joint.h"
#include "robot/joint/two_axis_search.h"

namespace tact::joint {

Joint FitLeastSquares(JointType type, std::span<const Transform> poses);

/// Shows every pose to its argument, in order; the same ones each time it is called.
using PosePass = std::function<void(const std::function<void(const Transform&)>&)>;

/// From poses that need not fit into memory.
Joint FitLeastSquares(JointType type, const PosePass& pass);

/// The two-axis joint of least squares for given axes.
Joint FitCenters(const TwoAxes& axes, const PosePass& pass);
PosePass PassOver(std::span<const Transform> poses);

/// The starts from which the likelihood is climbed: FitLeastSquares and, where the axis follows from how the link
/// turns, the axis along (planar: across) which it moves.
std::vector<Joint> StartsOf(JointType type, std::span<const Transform> poses);

/// The angle plus whole turns that is nearest to another.
double ContinuousWith(double angle, double previous);

/// Angles made continuous along their order: each differs from the one before by at most pi [thesis, 4.4.1].
void Unwrap(std::span<double> angles);

}  // namespace tact::joint

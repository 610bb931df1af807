/// @file
/// One placing of the frame J among the many that allow the same poses.
/// Model   The set of poses stays when J turns or moves along with a coordinate, and when the axis is reversed.
#pragma once

#include <span>

#include "robot/joint/joint.h"

namespace tact::joint {

/// The same poses, with M(q) and M(0) exchanged for M(0): the pose at q gets the coordinates zero.
Joint ZeroedAt(const Joint& joint, const Coordinates& q);

/// The same poses with the axis reversed (planar: the normal; two-axis: both axes; rigid, spherical: as it is).
Joint Reversed(const Joint& joint);

/// A two-axis joint with the second axis alone reversed, so that the offset changes its sign; others as they are.
Joint OffsetReversed(const Joint& joint);

/// The same poses: coordinates zero near the first pose; the first coordinate positive where it is farthest from zero;
/// the offset not negative.
Joint InNormalForm(const Joint& joint, std::span<const Transform> poses);

/// The same poses, reversed where that brings the axes nearer to the other's, of the same type.
Joint AlignedWith(const Joint& joint, const Joint& other);

}  // namespace tact::joint

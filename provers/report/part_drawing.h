/// @file
/// A scan divided into parts, with the axis about which they turn: a dot a point.
/// Model   orthographic, obliquely from the side on which the origin lies, where a scanner is; nothing hides anything.
#pragma once

#include <optional>
#include <string>

#include "robot/perception/part_joint.h"

namespace tact::provers {

/// An <svg> element: the first part blue, the second red, undecided points grey, the axis black. At most `dots` points, evenly
/// spread.
std::string DrawParts(std::span<const Eigen::Vector3d> points, std::span<const perception::Part> parts,
                      const perception::PartAxis* axis, std::size_t dots = 4000);

}  // namespace tact::provers

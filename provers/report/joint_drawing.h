/// @file
/// A joint among the poses it was estimated from, as SVG: A's origin on its way, small frames of A, the axis with its uncertainty.
/// Frames  all in B; its axes are in the lower left corner.
/// Exact   no.
#pragma once

#include <span>
#include <string>

#include "robot/joint/joint_parameters.h"

namespace tact::provers {

enum class JointView { kFromTheSide, kAlongTheAxis };

struct JointPicture {
  const joint::JointFit& fit;
  std::span<const joint::NamedParameter> parameters;
  std::span<const joint::Transform> poses;
  std::span<const std::size_t> outliers;  // ascending
};

std::string DrawJoint(const JointPicture& picture, JointView view);

}  // namespace tact::provers

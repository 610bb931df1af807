/// @file
/// The report of `tact joint -o FILE`: one page, self-contained.
/// Errors  InputError: the file cannot be written.
#pragma once

#include <string>

#include "cli/joint_answer.h"
#include "robot/cad/length_unit.h"

namespace tact::cli {

void WriteJointPage(const JointAnswer& answer, cad::LengthUnit unit, const std::string& path);

}  // namespace tact::cli

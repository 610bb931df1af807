/// @file
/// Motion DOFs as a table for people.
#pragma once

#include <string>

#include "algebra/contact/motion_dof.h"

namespace tact::cli {

/// Lines with their ends; says so where the relation is singular.
std::string DofTable(const algebra::MotionDof& dof);

}  // namespace tact::cli

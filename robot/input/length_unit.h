/// @file
/// Length units that a JSON file may name; the units themselves are robot/cad/length_unit.h's.
#pragma once

#include "robot/cad/length_unit.h"
#include "robot/input/json_value.h"

namespace tact::input {

/// "mm", "cm", "m" or "in"; InputError for anything else.
cad::LengthUnit ParseLengthUnit(const JsonValue& value);

}  // namespace tact::input

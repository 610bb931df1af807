/// @file
/// Length units that a file may name.
/// Exact   conversions are rational: an inch is 127/5 mm.
#pragma once

#include <string>

#include "algebra/exact/rational.h"
#include "robot/input/json_value.h"

namespace tact::input {

enum class LengthUnit { kMillimetre, kCentimetre, kMetre, kInch };

/// "mm", "cm", "m" or "in"; InputError for anything else.
LengthUnit ParseLengthUnit(const JsonValue& value);
std::string ToString(LengthUnit unit);
algebra::Rational MillimetresPer(LengthUnit unit);

}  // namespace tact::input

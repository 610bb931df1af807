/// @file
/// A rope's curve in space, three numbers a line, to P-data.
/// Errors  InputError `source:line:column: expected this, got that`.
#pragma once

#include <string>
#include <string_view>

#include "algebra/knot/p_data.h"

namespace tact::input {

/// Seen against the direction `view`, "x,y,z"; empty: from above.
knot::PData ReadCurvePData(std::string_view text, const std::string& source, const std::string& view);

}  // namespace tact::input

/// @file
/// P-data as text: the thesis' three rows, or the last two, or {"sigma":[...],"attr":[...]}.
/// Errors  InputError `source:line:column: expected this, got that`.
#pragma once

#include <string>
#include <string_view>

#include "algebra/knot/p_data.h"

namespace tact::input {

/// source names the text in messages.
knot::PData ParsePData(std::string_view text, const std::string& source);

/// Of a file, a name of examples/knots, or the text itself.
knot::PData ReadPData(const std::string& argument);

}  // namespace tact::input

/// @file
/// PD codes of an open rope as text (algebra/knot/pd_code.h).
/// Model   "PD[X[0,3,1,4],X[4,1,5,2],X[2,5,3,6]]", with or without the words PD and X, a semicolon at the end.
/// Errors  InputError `source:line:column: expected this, got that`.
#pragma once

#include "algebra/knot/p_data.h"
#include "robot/input/text_token.h"

namespace tact::input {

/// Whether the text starts with "PD", "X" or "[".
bool LooksLikePd(std::string_view text);

knot::PData ParsePd(const SourceText& text);

}  // namespace tact::input

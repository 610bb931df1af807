/// @file
/// Signed Gauss codes as text (algebra/knot/gauss_code.h).
/// Model   "O1+ U2+ U1+ O2+", or the passes and then the signs of intersections 1..c: "1 -2 -1 2 / + +", "1 -2 -1 2 ++",
///         "{1,-2,-1,2},{+,+}".
/// Errors  InputError `source:line:column: expected this, got that`. Knoto-ID's list of arcs outside is refused: P-data
///         live on a sphere, where no face is the outer one.
#pragma once

#include "algebra/knot/p_data.h"
#include "robot/input/text_token.h"

namespace tact::input {

/// Whether the text starts with O or U and a digit.
bool LooksLikeLetteredGauss(std::string_view text);
/// Whether a word of the text consists of signs only.
bool LooksLikeNumberedGauss(const SourceText& text);

knot::PData ParseLetteredGauss(const SourceText& text);
knot::PData ParseNumberedGauss(const SourceText& text);

}  // namespace tact::input

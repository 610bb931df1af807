/// @file
/// Length units of CAD data. Mesh files name none: whoever reads one says which it is in.
/// Exact   an inch is 25.4 mm.
#pragma once

#include <optional>
#include <string_view>

#include "algebra/exact/rational.h"

namespace tact::cad {

enum class LengthUnit { kMillimetre, kCentimetre, kMetre, kInch };

/// "mm", "cm", "m" or "in"; nullopt for anything else.
std::optional<LengthUnit> ParseLengthUnit(std::string_view text);
std::string_view ToString(LengthUnit unit);
algebra::Rational InMillimetres(LengthUnit unit);
/// How many targets one unit is.
algebra::Rational Ratio(LengthUnit unit, LengthUnit target);

}  // namespace tact::cad

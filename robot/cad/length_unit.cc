#include "robot/cad/length_unit.h"

namespace tact::cad {
namespace {

constexpr LengthUnit kUnits[] = {LengthUnit::kMillimetre, LengthUnit::kCentimetre, LengthUnit::kMetre,
                                 LengthUnit::kInch};

}  // namespace

std::string_view ToString(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMillimetre:
      return "mm";
    case LengthUnit::kCentimetre:
      return "cm";
    case LengthUnit::kMetre:
      return "m";
    case LengthUnit::kInch:
      return "in";
  }
  return "";
}

std::optional<LengthUnit> ParseLengthUnit(std::string_view text) {
  for (const LengthUnit unit : kUnits) {
    if (ToString(unit) == text) return unit;
  }
  return std::nullopt;
}

algebra::Rational InMillimetres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMillimetre:
      return 1;
    case LengthUnit::kCentimetre:
      return 10;
    case LengthUnit::kMetre:
      return 1000;
    case LengthUnit::kInch:
      return {127, 5};
  }
  return 1;
}

algebra::Rational Ratio(LengthUnit unit, LengthUnit target) {
  return InMillimetres(unit) / InMillimetres(target);
}

}  // namespace tact::cad

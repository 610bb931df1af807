#include "robot/input/length_unit.h"

namespace tact::input {
namespace {

constexpr LengthUnit kUnits[] = {LengthUnit::kMillimetre, LengthUnit::kCentimetre, LengthUnit::kMetre,
                                 LengthUnit::kInch};

}  // namespace

LengthUnit ParseLengthUnit(const JsonValue& value) {
  constexpr std::string_view kWanted = "a length unit, \"mm\", \"cm\", \"m\" or \"in\"";
  const std::string name = value.ReadString(kWanted);
  for (const LengthUnit unit : kUnits) {
    if (name == ToString(unit)) return unit;
  }
  value.FailExpected(kWanted);
}

std::string ToString(LengthUnit unit) {
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
  throw InvariantError("a length unit without a name");
}

algebra::Rational MillimetresPer(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMillimetre:
      return 1;
    case LengthUnit::kCentimetre:
      return 10;
    case LengthUnit::kMetre:
      return 1000;
    case LengthUnit::kInch:
      return algebra::Rational(127, 5);
  }
  throw InvariantError("a length unit without a length");
}

}  // namespace tact::input

#include "robot/input/length_unit.h"

namespace tact::input {

cad::LengthUnit ParseLengthUnit(const JsonValue& value) {
  constexpr std::string_view kWanted = "a length unit, \"mm\", \"cm\", \"m\" or \"in\"";
  const auto unit = cad::ParseLengthUnit(value.ReadString(kWanted));
  if (!unit) value.FailExpected(kWanted);
  return *unit;
}

}  // namespace tact::input

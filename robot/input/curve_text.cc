#include "robot/input/curve_text.h"

#include "algebra/error.h"

namespace tact::input {

knot::PData ReadCurvePData(std::string_view, const std::string& source, const std::string&) {
  throw InputError(source + ":1:1: expected P-data, got a curve");
}

}  // namespace tact::input

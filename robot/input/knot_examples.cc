#include "robot/input/knot_examples.h"

namespace tact::input {

std::optional<std::string_view> KnotExample(std::string_view) { return std::nullopt; }

}  // namespace tact::input

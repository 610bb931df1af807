/// @file
/// The rope curves of examples/knots, by name.
#pragma once

#include <optional>
#include <string_view>

namespace tact::input {

/// The text of examples/knots/<name>.xyz; nullopt: there is none.
std::optional<std::string_view> KnotExample(std::string_view name);

}  // namespace tact::input

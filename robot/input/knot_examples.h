/// @file
/// The rope curves of examples/knots, as they are, in the program: their names stand where P-data are asked for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tact::input {

struct KnotExample {
  std::string name;       // "bowline"
  std::string source;     // "examples/knots/bowline.xyz"
  std::string_view text;  // curve_text.h
};

/// By name.
const std::vector<KnotExample>& KnotExamples();
std::optional<KnotExample> FindKnotExample(std::string_view name);
/// "bow_tie, bowline, ..."
std::string KnotExampleNames();

}  // namespace tact::input

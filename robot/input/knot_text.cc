#include "robot/input/knot_text.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "robot/input/json_value.h"

namespace tact::input {
namespace {

std::vector<int> ReadRow(const JsonValue& row) {
  std::vector<int> numbers;
  for (const JsonValue number : row.Elements("an array of numbers"))
    numbers.push_back(static_cast<int>(number.ReadInteger(-1000000, 1000000)));
  return numbers;
}

}  // namespace

knot::PData ParsePData(std::string_view text, const std::string& source) {
  const JsonDocument document = JsonDocument::Parse(std::string(text), source);
  const JsonValue root = document.root();
  root.ExpectObject({"sigma", "attr", "name"});
  const auto sigma = ReadRow(root.At("sigma")), attr = ReadRow(root.At("attr"));
  if (const auto fault = knot::PData::FindFault(sigma, attr)) root.Fail(fault->what);
  return knot::PData(sigma, attr);
}

knot::PData ReadPData(const std::string& argument) {
  if (!std::filesystem::exists(argument)) return ParsePData(argument, "<argument>");
  std::ifstream file(argument);
  std::stringstream text;
  text << file.rdbuf();
  return ParsePData(text.str(), argument);
}

}  // namespace tact::input

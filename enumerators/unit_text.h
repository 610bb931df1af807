/// @file
/// The texts of a census' units: writing and reading lists of numbers, and what tells one run from another.
/// Errors  InputError: a text that is not just what was to be written, with the byte.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "enumerators/contact_world.h"

namespace tact::enumerators {

/// "[1,2,3]"
template <typename Number>
std::string ListText(const std::vector<Number>& numbers) {
  std::string text = "[";
  for (const Number n : numbers) text += (text.size() > 1 ? "," : "") + std::to_string(n);
  return text + "]";
}

/// Reads a text from its beginning, piece by expected piece.
class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {}

  /// Whether that comes next; if so, it is passed.
  bool Take(std::string_view expected);
  void Expect(std::string_view expected);
  void ExpectEnd() const;
  /// A number that is not negative.
  template <typename T>
  T Number() {
    T number{};
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error != std::errc() || number < T{0}) Refuse("a count");
    at_ = static_cast<size_t>(end - text_.data());
    return number;
  }
  /// "[1,2,3]"
  template <typename T>
  std::vector<T> Numbers() {
    std::vector<T> numbers;
    Expect("[");
    while (!Take("]")) {
      if (!numbers.empty()) Expect(",");
      numbers.push_back(Number<T>());
    }
    return numbers;
  }
  [[noreturn]] void Refuse(const std::string& expected) const;

 private:
  std::string_view text_;
  size_t at_ = 0;
};

/// {"kind":...,"version":...,"world":...}: the world with a digest of its contacts, and how it is cut into units.
std::string DescribeRun(const std::string& kind, const std::string& version, const std::string& world_name,
                        const ContactWorld& world, uint64_t relations, uint64_t relations_in_a_unit);

}  // namespace tact::enumerators

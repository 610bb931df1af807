/// @file
/// A text file's lines as words, with the checks that all mesh formats share.
/// Errors  InputError: "name:line: expected ..., got ...".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tact::cad {

class TextLines {
 public:
  TextLines(std::string_view contents, std::string name, bool hash_starts_comment);

  /// Goes to the next line that has words; false at the end of the file.
  bool Next();
  const std::vector<std::string_view>& words() const { return words_; }
  size_t line() const { return line_; }
  /// Where the line after the current one starts.
  size_t offset() const { return offset_; }

  /// Refuses the current line, or the file's end if there is no line left.
  [[noreturn]] void Fail(const std::string& expected, const std::string& got) const;
  [[noreturn]] void Fail(const std::string& expected) const;

  /// Refuses a word that is no finite double. Notes one that does not survive as a double.
  void CheckNumber(std::string_view word, std::vector<std::string>* notes) const;
  /// A whole number from low to high.
  long long Whole(std::string_view word, long long low, long long high, const std::string& what) const;

 private:
  std::string_view contents_;
  std::string name_;
  bool hash_starts_comment_;
  bool at_end_ = false;
  size_t offset_ = 0;
  size_t line_ = 0;
  std::vector<std::string_view> words_;
};

/// A double if the word is one and it is finite.
std::optional<double> ParseFinite(std::string_view word);

/// The words, with single blanks between, and a line's end.
void AppendLine(const std::vector<std::string_view>& words, std::string* text);

}  // namespace tact::cad

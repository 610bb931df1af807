/// @file
/// Words of a text with their places, for forms that are no JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tact::input {

/// A text from outside; it outlives its words.
struct SourceText {
  std::string_view text;
  std::string source;     // names the text in messages
  size_t first_line = 1;  // its first line's number there

  /// Throws InputError `source:line:column: message`; columns count characters from 1.
  [[noreturn]] void Fail(size_t offset, const std::string& message) const;
};

struct Word {
  std::string_view text;
  size_t offset = 0;  // in its text
};

/// The words between blanks, line ends apart; each character of `single` is a word of its own, each of `skipped` a blank.
std::vector<Word> WordsOf(const SourceText& text, std::string_view single, std::string_view skipped = "");

/// The whole number that the word writes, within [low, high]; `what` names what was expected.
int ReadWholeNumber(const SourceText& text, const Word& word, int low, int high, std::string_view what);

}  // namespace tact::input

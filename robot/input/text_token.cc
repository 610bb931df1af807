#include "robot/input/text_token.h"

#include <charconv>

#include "algebra/error.h"
#include "robot/input/json_value.h"

namespace tact::input {

void SourceText::Fail(size_t offset, const std::string& message) const {
  size_t line = first_line, column = 1;
  for (size_t i = 0; i < offset; ++i) {
    if (text[i] == '\n') {
      ++line;
      column = 1;
    } else if ((text[i] & 0xC0) != 0x80) {
      ++column;
    }
  }
  throw InputError(source + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message);
}

std::vector<Word> WordsOf(const SourceText& text, std::string_view single, std::string_view skipped) {
  const auto is_in = [](std::string_view set, char c) { return set.find(c) != std::string_view::npos; };
  std::vector<Word> words;
  bool open = false;
  for (size_t i = 0; i < text.text.size(); ++i) {
    const char c = text.text[i];
    const bool alone = is_in(single, c);
    if (!alone && (is_in(" \t\r\n", c) || is_in(skipped, c))) {
      open = false;
      continue;
    }
    if (alone || !open) words.push_back({text.text.substr(i, 0), i});
    words.back().text = text.text.substr(words.back().offset, i + 1 - words.back().offset);
    open = !alone;
  }
  return words;
}

int ReadWholeNumber(const SourceText& text, const Word& word, int low, int high, std::string_view what) {
  const auto refuse = [&]() {
    text.Fail(word.offset, "expected " + std::string(what) + ", got " + Quote(word.text));
  };
  int number = 0;
  const char* end = word.text.data() + word.text.size();
  const auto [stop, error] = std::from_chars(word.text.data(), end, number);
  if (error != std::errc() || stop != end || number < low || number > high) refuse();
  return number;
}

}  // namespace tact::input

#include "robot/cad/text_lines.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "algebra/error.h"
#include "algebra/exact/rational.h"

namespace tact::cad {
namespace {

constexpr size_t kMostNotes = 5;
constexpr size_t kDigitsAlwaysKept = 15;

size_t CountDigits(std::string_view number) {
  size_t digits = 0;
  for (const char c : number.substr(0, number.find_first_of("eE"))) {
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

// Words go into messages: unprintable and long ones are cut short.
std::string Quoted(std::string_view word) {
  constexpr size_t kLongest = 60;
  std::string text = "\"";
  for (const char c : word.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > kLongest ? "...\"" : "\"");
}

}  // namespace

TextLines::TextLines(std::string_view contents, std::string name, bool hash_starts_comment)
    : contents_(contents), name_(std::move(name)), hash_starts_comment_(hash_starts_comment) {}

bool TextLines::Next() {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  words_.clear();
  while (words_.empty() && offset_ < contents_.size()) {
    const size_t end = std::min(contents_.find('\n', offset_), contents_.size());
    std::string_view rest = contents_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, contents_.size());
    ++line_;
    if (hash_starts_comment_) rest = rest.substr(0, rest.find('#'));
    for (size_t start = rest.find_first_not_of(kBlanks); start != std::string_view::npos;
         start = rest.find_first_not_of(kBlanks)) {
      rest.remove_prefix(start);
      const size_t stop = std::min(rest.find_first_of(kBlanks), rest.size());
      words_.push_back(rest.substr(0, stop));
      rest.remove_prefix(stop);
    }
  }
  at_end_ = words_.empty();
  return !at_end_;
}

void TextLines::Fail(const std::string& expected, const std::string& got) const {
  throw InputError(name_ + ":" + std::to_string(line_) + ": expected " + expected + ", got " + got);
}

void TextLines::Fail(const std::string& expected) const {
  if (at_end_) Fail(expected, "the end of the file");
  std::string text;
  for (const std::string_view word : words_) text += (text.empty() ? "" : " ") + std::string(word);
  Fail(expected, Quoted(text));
}

void TextLines::CheckNumber(std::string_view word, std::vector<std::string>* notes) const {
  const std::optional<double> value = ParseFinite(word);
  if (!value) Fail("a finite number in the range of a double", Quoted(word));
  const size_t digits = CountDigits(word);
  if (digits <= kDigitsAlwaysKept || notes == nullptr || notes->size() > kMostNotes) return;
  const auto taken = algebra::Rational::FromShortestDecimal(*value);
  if (algebra::Rational::Parse(word) == taken) return;
  if (notes->size() == kMostNotes) {
    notes->push_back(name_ + ": and more numbers of too many digits");
    return;
  }
  char shortest[64];
  const auto end = std::to_chars(shortest, shortest + sizeof shortest, *value).ptr;
  notes->push_back(name_ + ":" + std::to_string(line_) + ": " + Quoted(word) + " has " +
                   std::to_string(digits) + " significant digits and is taken as " +
                   std::string(shortest, end));
}

long long TextLines::Whole(std::string_view word, long long low, long long high,
                           const std::string& what) const {
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && end == word.data() + word.size() && low <= value && value <= high) return value;
  Fail(what + " from " + std::to_string(low) + " to " + std::to_string(high), Quoted(word));
}

std::optional<double> ParseFinite(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

void AppendLine(const std::vector<std::string_view>& words, std::string* text) {
  for (const std::string_view word : words) {
    *text += word;
    *text += ' ';
  }
  *text += '\n';
}

}  // namespace tact::cad

#include "robot/input/json_value.h"

#include <algorithm>
#include <charconv>

namespace tact::input {
namespace {

constexpr std::string_view kNumberCharacters = "0123456789+-.eE";
constexpr size_t kLongestQuote = 40;

std::string_view NameOf(JsonKind kind) {
  switch (kind) {
    case JsonKind::kNull:
      return "null";
    case JsonKind::kFalse:
      return "false";
    case JsonKind::kTrue:
      return "true";
    case JsonKind::kNumber:
      return "a number";
    case JsonKind::kString:
      return "a string";
    case JsonKind::kArray:
      return "an array";
    case JsonKind::kObject:
      return "an object";
  }
  throw InvariantError("a JSON value of no kind");
}

}  // namespace

std::string Quote(std::string_view text) {
  std::string quoted = "\"";
  const bool shorten = text.size() > kLongestQuote;
  if (shorten) {
    size_t length = kLongestQuote;
    while (length > 0 && (text[length] & 0xC0) == 0x80) --length;  // not within a UTF-8 character
    text = text.substr(0, length);
  }
  for (const char c : text) quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  return quoted + (shorten ? "...\"" : "\"");
}

std::string QuoteList(const std::vector<std::string_view>& words) {
  std::string list;
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? " and " : ", ";
    list += Quote(words[i]);
  }
  return list;
}

JsonValue JsonDocument::root() const { return JsonValue(this, 0); }

std::string JsonDocument::Where(size_t offset) const {
  const std::string_view before = std::string_view(text_).substr(0, offset);
  const size_t line = first_line_ + static_cast<size_t>(std::count(before.begin(), before.end(), '\n'));
  const size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  const std::string_view in_line = before.substr(line_start);
  const auto characters =
      std::count_if(in_line.begin(), in_line.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return source_ + ":" + std::to_string(line) + ":" + std::to_string(characters + 1);
}

std::string_view JsonDocument::String(const Node& node) const {
  if (node.extra != kNone) return unescaped_[node.extra];
  const size_t start = node.offset + size_t{1};
  return std::string_view(text_).substr(start, text_.find('"', start) - start);
}

std::string_view JsonDocument::Number(const Node& node) const {
  const size_t end = text_.find_first_not_of(kNumberCharacters, node.offset);
  return std::string_view(text_).substr(node.offset, end - node.offset);
}

void JsonValue::Fail(const std::string& message) const { throw InputError(Where() + ": " + message); }

void JsonValue::FailExpected(std::string_view what) const {
  Fail("expected " + std::string(what) + ", got " + Describe());
}

std::string JsonValue::Describe() const {
  switch (kind()) {
    case JsonKind::kNumber:
      return "the number " + std::string(document_->Number(node()));
    case JsonKind::kString:
      return "the string " + Quote(document_->String(node()));
    case JsonKind::kArray:
      if (size() == 0) return "an empty array";
      return "an array of " + std::to_string(size()) + (size() == 1 ? " value" : " values");
    case JsonKind::kObject:
      return size() == 0 ? "an empty object" : "an object";
    default:
      return std::string(NameOf(kind()));
  }
}

void JsonValue::ExpectObject(std::initializer_list<std::string_view> known_keys) const {
  const std::vector<std::string_view> known(known_keys);
  if (!is_object()) FailExpected("an object with the keys " + QuoteList(known));
  for (uint32_t i = index_ + 1; i < node().end; i = document_->nodes_[i + 1].end) {
    const std::string_view key = document_->String(document_->nodes_[i]);
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      JsonValue(document_, i).Fail("expected one of the keys " + QuoteList(known) + ", got " + Quote(key));
    }
  }
}

std::optional<JsonValue> JsonValue::Find(std::string_view key) const {
  for (uint32_t i = index_ + 1; i < node().end; i = document_->nodes_[i + 1].end) {
    if (document_->String(document_->nodes_[i]) == key) return JsonValue(document_, i + 1);
  }
  return std::nullopt;
}

JsonValue JsonValue::At(std::string_view key) const {
  if (const auto found = Find(key)) return *found;
  std::vector<std::string_view> keys;
  for (uint32_t i = index_ + 1; i < node().end; i = document_->nodes_[i + 1].end) {
    keys.push_back(document_->String(document_->nodes_[i]));
  }
  Fail("expected the key " + Quote(key) + ", got " +
       (keys.empty() ? "an empty object" : "an object with only " + QuoteList(keys)));
}

JsonValue::Range JsonValue::Elements(std::string_view what) const {
  if (!is_array()) FailExpected(what);
  return Range(*this);
}

algebra::Rational JsonValue::ReadRational() const {
  if (kind() != JsonKind::kNumber && kind() != JsonKind::kString) {
    FailExpected("a number or a string \"p/q\"");
  }
  const std::string_view text =
      kind() == JsonKind::kNumber ? document_->Number(node()) : document_->String(node());
  // Most numbers of a file are short integers; the general parser would allocate.
  int64_t small = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), small);
  if (error == std::errc() && end == text.data() + text.size())
    return algebra::Rational(static_cast<long>(small));
  if (text.size() > kLongestNumber) {
    Fail("expected a number of at most " + std::to_string(kLongestNumber) + " characters, got one of " +
         std::to_string(text.size()));
  }
  if (const auto value = algebra::Rational::Parse(text)) return *value;
  FailExpected("a number with an exponent of at most 400 or a string \"p/q\" with q not 0");
}

int64_t JsonValue::ReadInteger(int64_t low, int64_t high) const {
  const auto refuse = [&] {
    FailExpected("an integer from " + std::to_string(low) + " to " + std::to_string(high));
  };
  if (kind() != JsonKind::kNumber) refuse();
  const algebra::Rational value = ReadRational();
  if (!value.is_integer() || value < algebra::Rational(static_cast<long>(low)) ||
      value > algebra::Rational(static_cast<long>(high))) {
    refuse();
  }
  return value.numerator().small();
}

std::string JsonValue::ReadString(std::string_view what) const {
  if (kind() != JsonKind::kString) FailExpected(what);
  return std::string(document_->String(node()));
}

algebra::Vector3 JsonValue::ReadVector3() const {
  if (!is_array() || size() != 3) FailExpected("three numbers [x, y, z]");
  algebra::Vector3 vector;
  int i = 0;
  for (const JsonValue entry : Range(*this)) vector[i++] = entry.ReadRational();
  return vector;
}

std::vector<algebra::Rational> JsonValue::ReadNumbers(size_t count, std::string_view shape) const {
  if (!is_array() || size() != count) FailExpected(std::to_string(count) + " numbers " + std::string(shape));
  std::vector<algebra::Rational> numbers;
  for (const JsonValue entry : Range(*this)) numbers.push_back(entry.ReadRational());
  return numbers;
}

}  // namespace tact::input
